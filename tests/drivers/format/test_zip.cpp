// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/zip.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_zip {
namespace {

/// Of members that grow in turns.
std::string archive(const std::vector<std::pair<std::string, std::string>>& members) {
  ZipLayout layout;
  for (const auto& [name, bytes] : members) layout.add(name, bytes.size());
  std::string text;
  const auto write = [&](std::uint64_t at, std::string_view bytes) {
    if (text.size() < at + bytes.size()) text.resize(at + bytes.size());
    text.replace(at, bytes.size(), bytes);
  };
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t k = 0; k < members.size(); ++k) {
      const std::string& bytes = members[k].second;
      const std::size_t cut = bytes.size() / 2;
      const std::string part = half == 0 ? bytes.substr(0, cut) : bytes.substr(cut);
      layout.count(k, part);
      write(layout.begin(k) + (half == 0 ? 0 : cut), part);
    }
  }
  for (const ZipLayout::Piece& piece : layout.pieces()) write(piece.at, piece.bytes);
  return text;
}

class ZipTest : public testing::Test {
 protected:
  /// All members of an archive, read in pieces.
  std::vector<std::pair<std::string, std::string>> members(const std::string& bytes) {
    const InputBytes input(scratch_.write("a.zip", bytes));
    const ZipReader reader(input);
    std::vector<std::pair<std::string, std::string>> found;
    for (std::size_t k = 0; k < reader.members().size(); ++k) {
      std::string text;
      char piece[7];
      for (std::size_t n; (n = reader.read(k, text.size(), piece, sizeof piece)) > 0;) text.append(piece, n);
      EXPECT_EQ(text.size(), reader.members()[k].size);
      found.emplace_back(reader.members()[k].name, text);
    }
    return found;
  }
  ScratchFolder scratch_;
};
using LongZipTest = ZipTest;

TEST_F(ZipTest, ReadsBackItsOwn) {
  const std::vector<std::pair<std::string, std::string>> all{{"X.npy", "0123456789"}, {"t.npy", ""}, {"b", "\0x\xff"}};
  EXPECT_EQ(members(archive(all)), all);
}

/// As unzip knows it, where that is installed.
TEST_F(LongZipTest, IsWhatOthersRead) {
  const std::string file = scratch_.write("a.zip", archive({{"one", "first"}, {"two", "second"}}));
  if (std::system("python3 -c 'import zipfile' > /dev/null 2>&1") != 0) GTEST_SKIP() << "no Python";
  const std::string program =
      "import zipfile, sys; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; "
      "assert z.read(\"one\") == b\"first\" and z.read(\"two\") == b\"second\"";
  EXPECT_EQ(std::system(("python3 -c '" + program + "' '" + file + "'").c_str()), 0);
}

/// Deflated, with 32 bits alone, as zlib and a hand make it.
std::string deflated(const std::string& name, const std::string& bytes) {
  std::string packed(::compressBound(bytes.size()), '\0');
  z_stream stream = {};
  EXPECT_EQ(::deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(::deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  ::deflateEnd(&stream);
  std::string text;
  const auto put = [&](std::uint64_t value, int size) {
    for (int k = 0; k < size; ++k) text += static_cast<char>(value >> (8 * k) & 0xff);
  };
  const auto facts = [&] {
    put(20, 2), put(0, 2), put(8, 2), put(0, 4);
    put(::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())), 4);
    put(packed.size(), 4), put(bytes.size(), 4), put(name.size(), 2), put(0, 2);
  };
  put(0x04034b50, 4), facts();
  text += name + packed;
  const std::size_t directory = text.size();
  put(0x02014b50, 4), put(20, 2), facts();
  put(0, 2), put(0, 2), put(0, 2), put(0, 4), put(0, 4);
  text += name;
  const std::size_t size = text.size() - directory;
  put(0x06054b50, 4), put(0, 4), put(1, 2), put(1, 2), put(size, 4), put(directory, 4), put(0, 2);
  return text;
}

TEST_F(ZipTest, InflatesLargeMembers) {
  std::string bytes;
  for (int k = 0; k < 100'000; ++k) bytes += std::to_string(k * k % 977);
  const auto found = members(deflated("X.npy", bytes));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].second == bytes);
}

/// Every byte that is cut off or flipped is seen, or changes nothing that was said.
TEST_F(ZipTest, SeesDamage) {
  const std::vector<std::pair<std::string, std::string>> all{{"X.npy", "0123456789"}, {"t.npy", "abc"}};
  for (const std::string& whole : {archive(all), deflated("X.npy", "0123456789 0123456789 0123456789")}) {
    const auto right = members(whole);
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_THROW(members(whole.substr(0, size)), InputError) << size;
    for (std::size_t at = 0; at < whole.size(); ++at) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
      try {
        const auto found = members(damaged);
        for (std::size_t k = 0; k < std::min(found.size(), right.size()); ++k)
          EXPECT_EQ(found[k].second, right[k].second) << at;
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_zip
