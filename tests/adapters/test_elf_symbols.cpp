// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/elf_symbols.hpp"

#include <elf.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "adapters/library.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_elf_symbols {
namespace {

namespace fs = std::filesystem;

/// A file of damaged bytes.
class ElfSymbols : public testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }

  static std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// Its symbols, or the reason why there are none.
  std::vector<std::string> symbols_of(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
    try {
      return exported_symbols(file_);
    } catch (const LibraryError& error) {
      return {std::string("refused: ") + error.what()};
    }
  }

  std::string file_ = (fs::temp_directory_path() / ("assay-test-elf-" + std::to_string(::getpid()))).string();
};

TEST_F(ElfSymbols, AreThoseThatTheLibraryDefines) {
  const std::vector<std::string> names = exported_symbols(double_library("mfront_norton"));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  const auto has = [&](const char* name) { return std::binary_search(names.begin(), names.end(), name); };
  EXPECT_TRUE(has("Norton_mfront_ept"));
  EXPECT_TRUE(has("Norton_Tridimensional"));
  EXPECT_FALSE(has("pow")) << "of the mathematical library";
  EXPECT_FALSE(has("integrate")) << "not exported";
}

TEST_F(ElfSymbols, OfWhatIsNoLibraryAreRefused) {
  EXPECT_EQ(symbols_of("").front(), "refused: is no shared library");
  EXPECT_EQ(symbols_of("\x7f"
                       "ELF")
                .front(),
            "refused: is no shared library");
  EXPECT_THROW(exported_symbols("/no/such/file.so"), LibraryError);
  EXPECT_THROW(exported_symbols("/tmp"), LibraryError);
}

TEST_F(ElfSymbols, OfTruncatedFilesAreReadOrRefused) {
  const std::string whole = bytes_of(double_library("mfront_norton"));
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> length(0, whole.size() - 1);
  for (int sample = 0; sample < 100; ++sample) {
    for (const std::string& name : symbols_of(whole.substr(0, length(random)))) EXPECT_LT(name.size(), 5000u);
  }
}

TEST_F(ElfSymbols, OfFilesWithFlippedBytesAreReadOrRefused) {
  const std::string whole = bytes_of(double_library("mfront_norton"));
  const auto& header = *reinterpret_cast<const Elf64_Ehdr*>(whole.data());
  std::mt19937 random(12);
  // half of the damage in the headers, where sizes and offsets are
  std::uniform_int_distribution<std::size_t> anywhere(0, whole.size() - 1), in_header(4, sizeof header - 1),
      in_sections(header.e_shoff, whole.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255), which(0, 3), count(1, 8);
  for (int sample = 0; sample < 200; ++sample) {
    std::string damaged = whole;
    for (int k = count(random); k > 0; --k) {
      const int part = which(random);
      const std::size_t at = part == 0 ? in_header(random) : part == 1 ? in_sections(random) : anywhere(random);
      damaged[at] = static_cast<char>(byte(random));
    }
    const std::vector<std::string> names = symbols_of(damaged);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  }
}

/// A header, two sections and bytes of a table of symbols and of their names.
std::string small_library(const Elf64_Shdr& symbols, const Elf64_Shdr& words, const std::string& rest) {
  Elf64_Ehdr header{};  // for this machine
  std::ifstream("/proc/self/exe", std::ios::binary).read(reinterpret_cast<char*>(&header), sizeof header);
  header.e_phnum = 0;
  header.e_shoff = sizeof header;
  header.e_shnum = 2;
  std::string bytes(reinterpret_cast<const char*>(&header), sizeof header);
  for (const Elf64_Shdr* section : {&symbols, &words}) {
    bytes.append(reinterpret_cast<const char*>(section), sizeof *section);
  }
  return bytes + rest;
}

TEST_F(ElfSymbols, WithoutEndsAreCut) {
  constexpr std::size_t begin = sizeof(Elf64_Ehdr) + 2 * sizeof(Elf64_Shdr), size = std::size_t{1} << 20;
  Elf64_Shdr symbols{}, words{};
  symbols.sh_type = SHT_DYNSYM;
  symbols.sh_link = 1;
  symbols.sh_offset = words.sh_offset = begin;
  symbols.sh_size = words.sh_size = size;
  // every symbol's name would be the rest of the file
  const std::vector<std::string> names = symbols_of(small_library(symbols, words, std::string(size, '\1')));
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(names.front().find_first_not_of('\1'), std::string::npos);
  EXPECT_LT(names.front().size(), 5000u);
}

TEST_F(ElfSymbols, OfTablesBeyondTheFileAreNone) {
  for (const std::uint64_t huge : {std::uint64_t{1} << 20, ~std::uint64_t{0}, ~std::uint64_t{0} - 7}) {
    Elf64_Shdr symbols{}, words{};
    symbols.sh_type = SHT_DYNSYM;
    symbols.sh_link = 1;
    symbols.sh_offset = huge;
    symbols.sh_size = huge;
    EXPECT_TRUE(symbols_of(small_library(symbols, words, "")).empty());
    symbols.sh_offset = 0;
    EXPECT_TRUE(symbols_of(small_library(symbols, words, "")).empty());
    symbols.sh_link = 2;
    symbols.sh_size = 24;
    EXPECT_TRUE(symbols_of(small_library(symbols, words, "")).empty()) << "no section of names";
  }
}

}  // namespace
}  // namespace assay::adapters::test_elf_symbols
