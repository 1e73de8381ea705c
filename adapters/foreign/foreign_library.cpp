// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_library.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include "adapters/elf_symbols.hpp"
#include "adapters/library.hpp"
#include "harness/material/material.hpp"
#include "harness/material/stack_below.hpp"

namespace assay::adapters {

namespace fs = std::filesystem;

namespace {

/// The companion library with the host's utility routines: beside the program, or in ../lib/assay/abaqus of it. Empty
/// where it is not found.
std::string utilities_library() {
  const char* name = "libassay_abaqus.so";
  std::error_code code;
  const fs::path folder = fs::read_symlink("/proc/self/exe", code).parent_path();
  for (const fs::path& candidate : {folder / name, folder / ASSAY_LIBRARY_FOLDER / name}) {
    if (!code && fs::exists(candidate, code)) return candidate.lexically_normal().string();
  }
  return {};
}

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

#if defined(__x86_64__)
constexpr std::uint64_t jump_slot = R_X86_64_JUMP_SLOT;
#elif defined(__aarch64__)
constexpr std::uint64_t jump_slot = R_AARCH64_JUMP_SLOT;
#else
constexpr std::uint64_t jump_slot = 0;  ///< none is known: the loader keeps its way
#endif

constexpr std::size_t most_absent = 64;  ///< of a process; those beyond are left to the loader
using Routine = void (*)();

std::array<std::string, most_absent> absent_names;  ///< never changed again: a call may come from any thread

[[noreturn]] void end_call(std::size_t which) {
  static thread_local char words[256];
  std::snprintf(words, sizeof words, "called %s, %s", absent_names[which].c_str(), absent_words);
  leave_model(words);
  std::fprintf(stderr, "the model %s\n", words);
  constexpr int as_the_loader = 127;
  ::_exit(as_the_loader);
}

template <std::size_t... k>
constexpr std::array<Routine, most_absent> routines_of(std::index_sequence<k...>) {
  return {+[] { end_call(k); }...};
}
constexpr auto routines = routines_of(std::make_index_sequence<most_absent>());

/// Of one name always the same; null where there is no more.
Routine stand_in(const std::string& name) {
  static std::mutex guard;
  static std::size_t taken = 0;
  const std::lock_guard lock(guard);
  for (std::size_t k = 0; k < taken; ++k) {
    if (absent_names[k] == name) return routines[k];
  }
  if (taken == most_absent) return nullptr;
  absent_names[taken] = name;
  return routines[taken++];
}

/// Where the loader keeps what a library calls.
struct CallTable {
  const Elf64_Rela* relocations = nullptr;
  std::size_t bytes = 0;
  const Elf64_Sym* symbols = nullptr;
  const char* strings = nullptr;
};

/// The loader keeps addresses as integers.
void* address(Elf64_Addr place) {
  return reinterpret_cast<void*>(place);  // NOLINT(performance-no-int-to-ptr)
}

CallTable calls_of(const link_map& map) {
  CallTable table;
  for (const Elf64_Dyn* entry = map.l_ld; entry->d_tag != DT_NULL; ++entry) {
    const auto pointer = [&] { return address(entry->d_un.d_ptr); };
    if (entry->d_tag == DT_JMPREL) table.relocations = static_cast<const Elf64_Rela*>(pointer());
    if (entry->d_tag == DT_PLTRELSZ) table.bytes = entry->d_un.d_val;
    if (entry->d_tag == DT_SYMTAB) table.symbols = static_cast<const Elf64_Sym*>(pointer());
    if (entry->d_tag == DT_STRTAB) table.strings = static_cast<const char*>(pointer());
  }
  return table;
}

/// Of a library that is loaded, lazily bound: symbols that neither it nor anybody it was loaded with defines.
std::vector<std::string> missing_symbols(void* library, const std::string& path) {
  std::vector<std::string> missing = wanted_symbols(path);
  std::erase_if(missing, [library](const std::string& name) {
    return dlsym(library, name.c_str()) || dlsym(RTLD_DEFAULT, name.c_str());
  });
  return missing;
}

/// From now on a call of one of them ends the call of the model, as leave_model, with its name; the loader would end
/// the process.
void stand_in_for(const std::vector<std::string>& missing, void* library) {
  link_map* map = nullptr;
  if (jump_slot == 0 || missing.empty() || ::dlinfo(library, RTLD_DI_LINKMAP, &map) != 0) return;
  const CallTable table = calls_of(*map);
  if (!table.relocations || !table.symbols || !table.strings) return;
  for (std::size_t k = 0; k < table.bytes / sizeof(Elf64_Rela); ++k) {
    const Elf64_Rela& call = table.relocations[k];
    if (ELF64_R_TYPE(call.r_info) != jump_slot) continue;
    const std::string name = table.strings + table.symbols[ELF64_R_SYM(call.r_info)].st_name;
    if (std::find(missing.begin(), missing.end(), name) == missing.end()) continue;
    const Routine routine = stand_in(name);
    if (routine) std::memcpy(address(map->l_addr + call.r_offset), &routine, sizeof routine);
  }
}

thread_local std::jmp_buf* way_back = nullptr;
thread_local char words[256];

}  // namespace

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

std::string missing_words(const std::vector<std::string>& missing) {
  constexpr std::size_t most_named = 5;
  std::string names;
  for (std::size_t k = 0; k < std::min(missing.size(), most_named); ++k) {
    names += (k == 0 ? "" : k + 1 == missing.size() ? " and " : ", ") + missing[k];
  }
  if (missing.size() > most_named) names += " and " + std::to_string(missing.size() - most_named) + " more";
  return names.empty() ? "" : "calls " + names + ", " + absent_words;
}

std::optional<std::string> ended_in(const std::function<void()>& body) {
  std::jmp_buf here;
  if (setjmp(here) == 0) {  // nothing here is changed between this and the way back
    way_back = &here;
    fill_unset_memory();
    body();
    way_back = nullptr;
    return std::nullopt;
  }
  way_back = nullptr;
  return words;
}

void leave_model(const char* what) {
  if (way_back) {
    words[std::string(what).copy(words, sizeof words - 1)] = '\0';
    std::longjmp(*way_back, 1);
  }
  if (on_model_end) on_model_end(what);
}

}  // namespace assay::adapters
