// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/elf_symbols.hpp"

#include <elf.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "adapters/library.hpp"

namespace assay::adapters {

namespace fs = std::filesystem;

namespace {

bool read_at(std::ifstream& file, std::uint64_t offset, auto& first, std::size_t count = 1) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(
      file.read(reinterpret_cast<char*>(&first), static_cast<std::streamsize>(count * sizeof first)));
}

/// Whether every part that the loader would map lies in the file.
bool complete(std::ifstream& file, const Elf64_Ehdr& header, std::uint64_t size) {
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment;
    if (header.e_phoff > size || !read_at(file, header.e_phoff + i * sizeof segment, segment)) return false;
    if (segment.p_type != PT_LOAD) continue;
    if (segment.p_offset > size || segment.p_filesz > size - segment.p_offset) return false;
  }
  return true;
}

/// The machine that a file is for; 0: none that is known.
unsigned machine_of(const Elf64_Ehdr& header) {
  constexpr bool big = std::endian::native == std::endian::big;
  const bool other = (header.e_ident[EI_DATA] == ELFDATA2MSB) != big;
  const unsigned machine = header.e_machine;
  return other ? (machine & 0xffu) << 8 | machine >> 8 : machine;
}

std::string machine_words(unsigned machine) {
  constexpr std::pair<unsigned, const char*> known[] = {{EM_386, "x86 of 32 bits"}, {EM_X86_64, "x86-64"},
                                                        {EM_ARM, "ARM of 32 bits"}, {EM_AARCH64, "ARM of 64 bits"},
                                                        {EM_RISCV, "RISC-V"},       {EM_PPC64, "POWER of 64 bits"},
                                                        {EM_S390, "IBM Z"}};
  const auto found = std::ranges::find(known, machine, &std::pair<unsigned, const char*>::first);
  return found == std::end(known) ? "number " + std::to_string(machine) + " of the ELF format" : found->second;
}

/// The loader says of such a file that it is not there.
void refuse_other_machine(const Elf64_Ehdr& header) {
  std::ifstream own("/proc/self/exe", std::ios::binary);
  Elf64_Ehdr ours{};
  if (!read_at(own, 0, ours) || machine_of(ours) == machine_of(header)) return;
  throw LibraryError("is for another machine: " + machine_words(machine_of(header)) + "; this one is " +
                     machine_words(machine_of(ours)));
}

/// `count` items at an offset; nothing where the file has not so many.
template <class T>
std::optional<std::vector<T>> items_at(std::ifstream& file, std::uint64_t size, std::uint64_t offset,
                                       std::uint64_t count) {
  if (offset > size || count > (size - offset) / sizeof(T)) return std::nullopt;
  std::vector<T> items(count);
  if (count > 0 && !read_at(file, offset, items.front(), count)) return std::nullopt;
  return items;
}

std::string text_at(const std::vector<char>& strings, std::uint64_t at) {
  constexpr std::size_t longest = 4096;  // of a damaged table without ends
  std::string text;
  for (; at < strings.size() && strings[at] && text.size() < longest; ++at) text += strings[at];
  return text;
}

/// A table of the library's, and the texts that its entries name.
template <class Entry>
struct Section {
  std::vector<Entry> entries;
  std::vector<char> strings;
};

/// The first table of a kind, empty where the library has none.
template <class Entry>
Section<Entry> section_of(const std::string& path, std::uint32_t kind) {
  check_shared_library(path);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
  const auto header = items_at<Elf64_Ehdr>(file, size, 0, 1);
  if (!header || header->front().e_ident[EI_CLASS] != ELFCLASS64) return {};
  const auto sections = items_at<Elf64_Shdr>(file, size, header->front().e_shoff, header->front().e_shnum);
  if (!sections) return {};
  for (const Elf64_Shdr& section : *sections) {
    if (section.sh_type != kind || section.sh_link >= sections->size()) continue;
    const Elf64_Shdr& words = (*sections)[section.sh_link];
    auto entries = items_at<Entry>(file, size, section.sh_offset, section.sh_size / sizeof(Entry));
    auto strings = items_at<char>(file, size, words.sh_offset, words.sh_size);
    if (entries && strings) return {std::move(*entries), std::move(*strings)};
  }
  return {};
}

/// Names of the dynamic symbols that `chosen` takes, sorted.
std::vector<std::string> symbols_of(const std::string& path, const auto& chosen) {
  const auto [symbols, strings] = section_of<Elf64_Sym>(path, SHT_DYNSYM);
  std::vector<std::string> names;
  for (const Elf64_Sym& symbol : symbols) {
    if (chosen(symbol)) names.push_back(text_at(strings, symbol.st_name));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// The libraries that one asks the loader for, and where it says they are: "A:B".
struct Needs {
  std::vector<std::string> libraries;
  std::string rpath, runpath;
};

/// A file that is no library needs none: the loader complains.
Needs needs_of(const std::string& library) try {
  const auto [entries, strings] = section_of<Elf64_Dyn>(library, SHT_DYNAMIC);
  Needs needs;
  for (const Elf64_Dyn& entry : entries) {
    const std::string text = text_at(strings, entry.d_un.d_val);
    if (entry.d_tag == DT_NULL) break;
    if (entry.d_tag == DT_NEEDED) needs.libraries.push_back(text);
    if (entry.d_tag == DT_RPATH) needs.rpath = text;
    if (entry.d_tag == DT_RUNPATH) needs.runpath = text;
  }
  return needs;
} catch (const LibraryError&) {
  return {};
}

using Folders = std::vector<std::string>;

/// The folders of "A:B", $ORIGIN for that of the library; an empty one is where the process stands.
Folders folders_in(const std::string& list, const std::string& origin) {
  Folders folders;
  std::istringstream parts(list);
  for (std::string part; std::getline(parts, part, ':');) {
    for (const std::string_view word : {"$ORIGIN", "${ORIGIN}"}) {
      if (const auto at = part.find(word); at != part.npos) part.replace(at, word.size(), origin);
    }
    folders.push_back(part.empty() ? "." : part);
  }
  return folders;
}

bool is_of_system(const std::string& path) {
  constexpr const char* folders[] = {"/lib/", "/lib64/", "/usr/lib/", "/usr/lib64/"};
  return std::ranges::any_of(folders, [&](const char* folder) { return path.starts_with(folder); });
}

/// Those of the loader's own list.
Folders configured_folders() {
  std::error_code code;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator("/etc/ld.so.conf.d", code)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  files.emplace_back("/etc/ld.so.conf");
  Folders folders;
  for (const fs::path& each : files) {
    std::ifstream file(each);
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("/")) folders.push_back(line);
    }
  }
  return folders;
}

/// Empty: none of the folders has it.
std::string file_in(const Folders& folders, const std::string& name) {
  std::error_code code;
  for (const std::string& folder : folders) {
    const fs::path file = fs::absolute(fs::path(folder) / name).lexically_normal();
    if (fs::is_regular_file(file, code)) return file.string();
  }
  return {};
}

class Search {
 public:
  /// `rpath`: of the libraries that ask for this one.
  void visit(const std::string& library, Folders rpath) {
    if (std::find(found.begin(), found.end(), library) != found.end()) return;
    found.push_back(library);
    const Needs needs = needs_of(library);
    const std::string origin = fs::path(library).parent_path().string();
    const char* given = std::getenv("LD_LIBRARY_PATH");
    if (needs.runpath.empty()) append(rpath, folders_in(needs.rpath, origin));
    Folders folders = needs.runpath.empty() ? rpath : Folders();
    for (const Folders& more : {folders_in(given ? given : "", origin), folders_in(needs.runpath, origin), configured_})
      append(folders, more);
    for (const std::string& name : needs.libraries) {
      const std::string file = file_in(name.find('/') == name.npos ? folders : Folders{"."}, name);
      if (!file.empty() && !is_of_system(file)) visit(file, rpath);
    }
  }

  std::vector<std::string> found;

 private:
  static void append(Folders& list, const Folders& more) { list.insert(list.end(), more.begin(), more.end()); }

  Folders configured_ = configured_folders();
};

}  // namespace

void check_shared_library(const std::string& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) throw LibraryError(no_such_library);
  if (!fs::is_regular_file(status)) throw LibraryError("is no shared library but a folder or device");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw LibraryError(std::string("cannot be read: ") + std::strerror(errno));
  Elf64_Ehdr header{};
  if (!read_at(file, 0, header.e_ident) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) {
    throw LibraryError("is no shared library");
  }
  constexpr std::uint64_t until_machine = offsetof(Elf64_Ehdr, e_version);
  if (fs::file_size(path, code) >= until_machine) {
    Elf64_Ehdr beginning{};
    read_at(file, 0, reinterpret_cast<char&>(beginning), until_machine);
    refuse_other_machine(beginning);
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return;  // the loader says it well
  if (!read_at(file, 0, header) || !complete(file, header, fs::file_size(path, code))) {
    throw LibraryError("is truncated: shorter than its headers say");
  }
}

std::vector<std::string> exported_symbols(const std::string& path) {
  return symbols_of(path, [](const Elf64_Sym& symbol) { return symbol.st_shndx != SHN_UNDEF; });
}

std::vector<std::string> own_symbols(const std::string& path) {
  return symbols_of(path, [](const Elf64_Sym& symbol) {
    return symbol.st_shndx != SHN_UNDEF && symbol.st_shndx != SHN_ABS && ELF64_ST_BIND(symbol.st_info) == STB_GLOBAL;
  });
}

std::vector<std::string> wanted_symbols(const std::string& path) {
  return symbols_of(path, [](const Elf64_Sym& symbol) {
    return symbol.st_shndx == SHN_UNDEF && symbol.st_name != 0 && ELF64_ST_BIND(symbol.st_info) == STB_GLOBAL;
  });
}

std::vector<std::string> with_needed_libraries(const std::string& library) {
  Search search;
  search.visit(fs::absolute(library).string(), {});
  return search.found;
}

}  // namespace assay::adapters
