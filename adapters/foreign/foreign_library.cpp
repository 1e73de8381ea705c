// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_library.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "adapters/elf_check.hpp"
#include "adapters/foreign/model_end.hpp"
#include "adapters/library.hpp"

namespace assay::adapters {

namespace fs = std::filesystem;

namespace {

std::string loader_message(const std::string& path) {
  const char* text = dlerror();
  std::string message = text ? text : "unknown reason";
  if (message.starts_with(path + ": ")) message.erase(0, path.size() + 2);
  return message;
}

/// "undefined symbol: foo_": foo_.
std::string undefined_symbol(const std::string& message) {
  const std::string words = "undefined symbol: ";
  const std::size_t at = message.find(words);
  return at == std::string::npos ? "" : message.substr(at + words.size());
}

/// Before a library of that folder.
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

LoadedLibrary load_foreign_library(const std::string& path) {
  check_shared_library(path);
  load_utilities(fs::path(path).parent_path().string());
  if (void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return {handle, {}};
  const std::string message = loader_message(path), missing = undefined_symbol(message);
  // many models name routines of their host that they never call
  if (void* handle = missing.empty() ? nullptr : dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL)) return {handle, missing};
  throw LibraryError("cannot be loaded: " + message);
}

}  // namespace assay::adapters
