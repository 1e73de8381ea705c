// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/library.hpp"

#include <dlfcn.h>
#include <sys/auxv.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <filesystem>

#include "adapters/elf_symbols.hpp"
#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/material/thrown.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

std::string loader_message(const std::string& path) {
  const char* text = dlerror();
  std::string message = text ? text : "unknown reason";
  if (message.starts_with(path + ": ")) message.erase(0, path.size() + 2);
  struct statvfs system = {};
  if (::statvfs(path.c_str(), &system) == 0 && (system.f_flag & ST_NOEXEC)) {
    message += "; its file system is mounted noexec: no code in it may run";
  }
  if (message.find("only ET_DYN and ET_EXEC can be loaded") != message.npos) {
    message = "it is an object file and no shared library: link it, as by gcc -shared -o model.so model.o";
  }
  return message;
}

int local_binding(const std::string& path) {
  if (is_sanitized) return RTLD_LOCAL;  // a sanitizer refuses libraries that are bound deeply
  const std::vector<std::string> own = own_symbols(path);
  // only where it must be: such a library does not find our _exit() either, which stands before libc's
  const bool twice = std::ranges::any_of(own, [](const auto& name) { return dlsym(RTLD_DEFAULT, name.c_str()); });
  return twice ? RTLD_LOCAL | RTLD_DEEPBIND : RTLD_LOCAL;
}

namespace {

/// More tables than any library would hold: its entry ignores the index.
constexpr std::uint32_t index_limit = 1000;

assay_material_entry_function entry_of(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | local_binding(path));
  if (!library) throw LibraryError("cannot be loaded: " + loader_message(path));
  void* symbol = dlsym(library, ASSAY_ENTRY_SYMBOL);
  if (!symbol) throw LibraryError("is no material library: it has no symbol " ASSAY_ENTRY_SYMBOL);
  return reinterpret_cast<assay_material_entry_function>(symbol);
}

/// The entry gave nothing for our major: does it serve another?
std::string majors_served(assay_material_entry_function entry) {
  for (std::uint32_t major = 0; major < 16; ++major) {
    const assay_material* table = nullptr;
    if (major != ASSAY_ABI_MAJOR) thrown_by(entry, [&] { table = entry(major, 0); });
    if (table) return "; it serves " + std::to_string(major);
  }
  return {};
}

std::string names_of(const std::vector<const assay_material*>& tables) {
  std::string names;
  for (const assay_material* table : tables) names += (names.empty() ? "" : ", ") + std::string(table->name);
  return names;
}

}  // namespace

std::vector<const assay_material*> tables_of_library(const std::string& path) {
  check_shared_library(path);
  const assay_material_entry_function entry = entry_of(std::filesystem::absolute(path).string());
  std::vector<const assay_material*> tables;
  const auto table_of = [&](std::uint32_t index) {
    const assay_material* table = nullptr;
    const std::string thrown = thrown_by(entry, [&] { table = entry(ASSAY_ABI_MAJOR, index); });
    if (!thrown.empty()) throw LibraryError("cannot serve: its entry " + thrown);
    return table;
  };
  for (std::uint32_t index = 0; const assay_material* table = table_of(index); ++index) {
    if (index == index_limit) throw LibraryError("its entry returns a table for every index");
    if (const auto defect = defect_of(table)) throw LibraryError("cannot serve: " + *defect);
    tables.push_back(table);
  }
  reset_arithmetic();
  if (tables.empty()) {
    throw LibraryError("holds no material for ABI major " + std::to_string(ASSAY_ABI_MAJOR) + majors_served(entry));
  }
  return tables;
}

const assay_material* table_of_library(const std::string& path, const std::string& name) {
  const auto tables = tables_of_library(path);
  if (name.empty() && tables.size() == 1) return tables.front();
  for (const assay_material* table : tables) {
    if (name == table->name) return table;
  }
  if (name.empty()) throw LibraryError("holds several materials; say which as FILE:NAME", names_of(tables));
  throw LibraryError("holds no material '" + name + "'", names_of(tables));
}

void* next_function(const char* name) { return dlsym(RTLD_NEXT, name); }

const std::string& own_library() {
  static const std::string found = [] {
    Dl_info own{}, program{};
    const unsigned long heads = ::getauxval(AT_PHDR);         // of the program's own file
    const void* head = reinterpret_cast<const void*>(heads);  // NOLINT(performance-no-int-to-ptr): the system's number
    const bool is_known = dladdr(reinterpret_cast<const void*>(&own_library), &own) != 0 && dladdr(head, &program) != 0;
    return is_known && own.dli_fbase != program.dli_fbase ? std::string(own.dli_fname) : std::string();
  }();
  return found;
}

std::string file_of(const assay_material* table) {
  Dl_info info{}, own{};
  if (dladdr(table, &info) == 0 || !info.dli_fname) return "";
  // the loader knows the program by the word it was called with, which need not be a path
  if (dladdr(reinterpret_cast<const void*>(&file_of), &own) != 0 && own.dli_fbase == info.dli_fbase) return own_file;
  return info.dli_fname;
}

}  // namespace assay::adapters
