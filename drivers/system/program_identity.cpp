// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/program_identity.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "drivers/system/input_file.hpp"
#include "drivers/text/sha256.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t largest_file = std::size_t{4} << 30;

/// A file that is loaded, and its build id in hexadecimal digits; empty: it has none.
struct Loaded {
  std::string file, build_id;
  bool is_ours = false;  ///< this code is in it
};

/// The note NT_GNU_BUILD_ID among the notes of a segment: a header, a name, a description, each filled up to 4 bytes.
std::string build_id_in(const unsigned char* notes, std::size_t size) {
  const auto padded = [](std::size_t n) { return (n + 3) / 4 * 4; };
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes + at, sizeof head);
    const std::size_t name = at + sizeof head, text = name + padded(head.n_namesz), end = text + padded(head.n_descsz);
    if (end > size) break;
    const bool is_gnu =
        head.n_namesz == sizeof ELF_NOTE_GNU && std::memcmp(notes + name, ELF_NOTE_GNU, sizeof ELF_NOTE_GNU) == 0;
    if (is_gnu && head.n_type == NT_GNU_BUILD_ID)
      return fmt::format("{:02x}", fmt::join(notes + text, notes + text + head.n_descsz, ""));
    at = end;
  }
  return {};
}

/// Whether what begins there in the file's own addresses is loaded from it.
bool is_mapped(const dl_phdr_info& info, ElfW(Addr) begin, std::size_t size) {
  for (int k = 0; k < info.dlpi_phnum; ++k) {
    const ElfW(Phdr)& all = info.dlpi_phdr[k];
    if (all.p_type == PT_LOAD && begin >= all.p_vaddr && begin + size <= all.p_vaddr + all.p_filesz) return true;
  }
  return false;
}

int add(dl_phdr_info* info, std::size_t, void* list) {
  Loaded found{info->dlpi_name ? info->dlpi_name : "", {}};
  found.is_ours = is_mapped(*info, reinterpret_cast<ElfW(Addr)>(&program_identity) - info->dlpi_addr, 1);
  for (int k = 0; k < info->dlpi_phnum && found.build_id.empty(); ++k) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[k];
    if (segment.p_type != PT_NOTE || !is_mapped(*info, segment.p_vaddr, segment.p_memsz)) continue;
    const ElfW(Addr) address = info->dlpi_addr + segment.p_vaddr;  // the loader gives addresses as numbers
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* notes = reinterpret_cast<const unsigned char*>(address);
    found.build_id = build_id_in(notes, segment.p_memsz);
  }
  static_cast<std::vector<Loaded>*>(list)->push_back(found);
  return 0;
}

/// The program comes first.
std::vector<Loaded> all_loaded() {
  std::vector<Loaded> all;
  dl_iterate_phdr(add, &all);
  return all;
}

std::string identity_of(const Loaded& code, const std::string& file) {
  return code.build_id.empty() ? sha256_hex(read_bytes(file, largest_file)) : code.build_id;
}

}  // namespace

const std::string& program_identity() {
  static const std::string identity = [] {
    const std::vector<Loaded> all = all_loaded();
    const auto ours = std::ranges::find_if(all, &Loaded::is_ours);
    const bool in_library = ours != all.begin() && ours != all.end();
    return in_library ? identity_of(*ours, ours->file) : identity_of(all.front(), "/proc/self/exe");
  }();
  return identity;
}

const std::string& loaded_identity() {
  static const std::string identity = [] {
    std::string all = program_identity();
    const std::vector<Loaded> loaded = all_loaded();
    for (std::size_t k = 1; k < loaded.size(); ++k) {
      if (loaded[k].file.find('/') == std::string::npos) continue;  // the kernel's own
      all += " " + identity_of(loaded[k], loaded[k].file);
    }
    return sha256_hex(all);
  }();
  return identity;
}

}  // namespace assay::drivers
