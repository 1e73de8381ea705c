// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/elf_check.hpp"

#include <elf.h>

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "adapters/library.hpp"

namespace assay::adapters {

namespace {

template <class T>
bool read_at(std::ifstream& file, std::uint64_t offset, T& value) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(&value), sizeof value));
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
  switch (machine) {
    case EM_386:
      return "x86 of 32 bits";
    case EM_X86_64:
      return "x86-64";
    case EM_ARM:
      return "ARM of 32 bits";
    case EM_AARCH64:
      return "ARM of 64 bits";
    case EM_RISCV:
      return "RISC-V";
    case EM_PPC64:
      return "POWER of 64 bits";
    case EM_S390:
      return "IBM Z";
  }
  return "number " + std::to_string(machine) + " of the ELF format";
}

/// The loader says of such a file that it is not there.
void refuse_other_machine(const Elf64_Ehdr& header) {
  std::ifstream own("/proc/self/exe", std::ios::binary);
  Elf64_Ehdr ours{};
  if (!read_at(own, 0, ours) || machine_of(ours) == machine_of(header)) return;
  throw LibraryError("is for another machine: " + machine_words(machine_of(header)) + "; this one is " +
                     machine_words(machine_of(ours)));
}

}  // namespace

void check_shared_library(const std::string& path) {
  namespace fs = std::filesystem;
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
    file.clear(), file.seekg(0);
    file.read(reinterpret_cast<char*>(&beginning), until_machine);
    refuse_other_machine(beginning);
  }
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return;  // the loader says it well
  if (!read_at(file, 0, header) || !complete(file, header, fs::file_size(path, code))) {
    throw LibraryError("is truncated: shorter than its headers say");
  }
}

}  // namespace assay::adapters
