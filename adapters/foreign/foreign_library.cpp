// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <map>
#include <mutex>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/absent_routines.hpp"
#include "adapters/foreign/model_end.hpp"
#include "adapters/library.hpp"

namespace assay::adapters {

namespace fs = std::filesystem;

namespace {

bool lacks_a_symbol(const std::string& message) { return message.find("undefined symbol: ") != std::string::npos; }

/// Before a library of which GETOUTDIR answers that folder.
void load_utilities(const std::string& folder) {
  static void* const library = [] {
    const std::string path = utilities_library();
    return path.empty() ? nullptr : dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  }();
  if (!library) return;
  using OnEnd = void (*)(const char* what);
  if (void* hook = dlsym(library, "assay_abaqus_on_end")) *static_cast<OnEnd*>(hook) = leave_model;
  constexpr std::size_t room = 4096;
  auto* place = static_cast<char*>(dlsym(library, "assay_abaqus_folder"));
  if (place) place[folder.copy(place, room - 1)] = '\0';
}

}  // namespace

std::string utilities_library() {
  const char* name = "libassay_abaqus.so";
  std::error_code code;
  const fs::path folder = fs::read_symlink("/proc/self/exe", code).parent_path();
  for (const fs::path& candidate : {folder / name, folder / ASSAY_LIBRARY_FOLDER / name}) {
    if (!code && fs::exists(candidate, code)) return candidate.lexically_normal().string();
  }
  return {};
}

LoadedLibrary load_foreign_library(const std::string& path, const std::string& folder) {
  static std::mutex guard;
  static std::map<std::string, LoadedLibrary> incomplete;  // which the loader takes for whole the next time
  const std::lock_guard lock(guard);
  if (const auto known = incomplete.find(path); known != incomplete.end()) return known->second;
  check_shared_library(path);
  load_utilities(folder.empty() ? fs::path(path).parent_path().string() : folder);
  const int binding = local_binding(path);
  if (void* handle = dlopen(path.c_str(), RTLD_NOW | binding)) return {handle, {}};
  const std::string message = loader_message(path);
  // many models name routines of their host that they never call
  if (void* handle = lacks_a_symbol(message) ? dlopen(path.c_str(), RTLD_LAZY | binding) : nullptr) {
    const std::vector<std::string> missing = missing_symbols(handle, path);
    stand_in_for(missing, handle);
    return incomplete[path] = {handle, missing};
  }
  throw LibraryError("cannot be loaded: " + message);
}

}  // namespace assay::adapters
