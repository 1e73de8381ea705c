// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/elf_check.hpp"

#include <elf.h>

#include <cerrno>
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
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return;  // the loader says it well
  if (!read_at(file, 0, header) || !complete(file, header, fs::file_size(path, code))) {
    throw LibraryError("is truncated: shorter than its headers say");
  }
}

}  // namespace assay::adapters
