// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/npy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/format/npy_rows.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_npy {
namespace {

/// An array as numpy.save leaves it: a header of version 1 without care for alignment, and the numbers.
std::string npy(const std::string& dictionary, const std::string& numbers, char version = 1) {
  std::string text = "\x93NUMPY";
  text += {version, '\0', static_cast<char>(dictionary.size() & 0xff), static_cast<char>(dictionary.size() >> 8)};
  if (version > 1) text += std::string(2, '\0');
  return text + dictionary + numbers;
}

std::string doubles(const std::vector<double>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

NpyHeader header(const std::string& dictionary, char version = 1) {
  return read_npy_header(npy(dictionary, "", version), {"a.npy"});
}

TEST(Npy, ReadsBackItsOwnHeaders) {
  const std::string plain = npy_header({3, 2}), named = npy_header({7}, {"X", "bx"});
  for (const std::string& text : {plain, named}) {
    EXPECT_EQ(text.size() % 64, 0u);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_EQ(read_npy_header(text, {}).size, text.size());
  }
  EXPECT_NE(plain.find("{'descr': '<f8', 'fortran_order': False, 'shape': (3,2), }"), plain.npos) << plain;
  EXPECT_NE(named.find("{'descr': [('X', '<f8'), ('bx', '<f8')], 'fortran_order': False, 'shape': (7,), }"),
            named.npos);
  EXPECT_EQ(read_npy_header(plain, {}).shape, (std::vector<std::uint64_t>{3, 2}));
  EXPECT_EQ(read_npy_header(plain, {}).elements(), 6u);
  ASSERT_EQ(read_npy_header(named, {}).fields.size(), 2u);
  EXPECT_EQ(read_npy_header(named, {}).fields[1].name, "bx");
  EXPECT_EQ(read_npy_header(named, {}).element_bytes(), 16u);
}

TEST(Npy, ReadsOtherTypesVersionsAndOrders) {
  const NpyHeader found = header("{'shape': (4, 3), 'fortran_order': True, 'descr': '>f4'}", 2);
  EXPECT_TRUE(found.by_columns);
  EXPECT_TRUE(found.fields[0].big_endian);
  EXPECT_EQ(found.fields[0].bytes, 4);
  EXPECT_EQ(npy_number("\x3f\xc0\x00\x00", found.fields[0]), 1.5);
  EXPECT_EQ(npy_number("\xfe\xff", {"", 'i', 2, false}), -2);
  EXPECT_EQ(npy_number("\xff\xfe", {"", 'u', 2, true}), 65534);
  EXPECT_EQ(npy_number("\xff", {"", 'i', 1, false}), -1);
  EXPECT_EQ(header("{'descr': '|u1', 'fortran_order': False, 'shape': (), }").elements(), 1u);
}

TEST(Npy, RefusesDamagedHeaders) {
  const std::vector<std::string> bad{"",
                                     "{",
                                     "{}",
                                     "{'descr': '<f8', 'fortran_order': False}",
                                     "{'descr': '<c16', 'fortran_order': False, 'shape': (1,)}",
                                     "{'descr': '|O', 'fortran_order': False, 'shape': (1,)}",
                                     "{'descr': '<f8', 'fortran_order': Maybe, 'shape': (1,)}",
                                     "{'descr': '<f8', 'fortran_order': False, 'shape': (-1,)}",
                                     "{'descr': '<f8', 'fortran_order': False, 'shape': (1",
                                     "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999, 99999999999)}",
                                     "{'descr': [('a', '<f8', (2,))], 'fortran_order': False, 'shape': (1,)}",
                                     "{'descr': [], 'fortran_order': False, 'shape': (1,)}",
                                     "{'descr': '<f8, 'fortran_order': False, 'shape': (1,)}"};
  for (const std::string& dictionary : bad) EXPECT_THROW(header(dictionary), InputError) << dictionary;
  EXPECT_THROW(header("{'descr': '<f8', 'fortran_order': False, 'shape': (1,)}", 9), InputError);
  const std::string whole = npy_header({1});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(read_npy_header(whole.substr(0, size), {}), InputError) << size;
}

class NpyRowsTest : public testing::Test {
 protected:
  std::vector<std::vector<double>> rows(const std::string& bytes) {
    const InputBytes input(scratch_.write("a", bytes));
    NpyRows found(input, {"X", "Y", "Z", "t"}, {{"X", {"X", "Y", "Z"}}}, "X");
    names_ = found.names();
    std::vector<std::vector<double>> all;
    for (std::vector<double> row; found.next(row);) all.push_back(row);
    return all;
  }
  ScratchFolder scratch_;
  std::vector<std::string> names_;
};

TEST_F(NpyRowsTest, OfAPlainArrayInBothOrders) {
  using Rows = std::vector<std::vector<double>>;
  const Rows expected{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(rows(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}", doubles({1, 2, 3, 4, 5, 6}))),
            expected);
  EXPECT_EQ(names_, (std::vector<std::string>{"X", "Y", "Z"}));
  EXPECT_EQ(rows(npy("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3)}", doubles({1, 4, 2, 5, 3, 6}))),
            expected);
  EXPECT_EQ(rows(npy("{'descr': [('t', '<f8'), ('Y', '<f8')], 'fortran_order': False, 'shape': (2,)}",
                     doubles({1, 2, 3, 4}))),
            (Rows{{1, 2}, {3, 4}}));
  EXPECT_EQ(names_, (std::vector<std::string>{"t", "Y"}));
}

/// As NumPy aligns the fields of its arrays.
TEST_F(NpyRowsTest, LeaveOutPadding) {
  const std::string four = "1234", type = "{'descr': [('X', '<f8'), ('', '|V4'), ('Y', '<f8')], ";
  EXPECT_EQ(rows(npy(type + "'fortran_order': False, 'shape': (1,)}", doubles({1}) + four + doubles({2}))),
            (std::vector<std::vector<double>>{{1, 2}}));
  EXPECT_THROW(rows(npy("{'descr': '|V8', 'fortran_order': False, 'shape': (1,)}", doubles({1}))), InputError);
  EXPECT_THROW(rows(npy("{'descr': [('', '|V8')], 'fortran_order': False, 'shape': (1,)}", doubles({1}))), InputError);
  EXPECT_THROW(rows(npy("{'descr': [('', '|V8')], 'fortran_order': False, 'shape': (1, 2)}", doubles({1, 2}))),
               InputError);
}

/// More rows than are held at a time.
TEST_F(NpyRowsTest, OfMoreThanOnePiece) {
  std::vector<double> values(2 * 10'000);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(k);
  const auto found = rows(npy_header({10'000, 2}) + doubles(values));
  ASSERT_EQ(found.size(), 10'000u);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k][0], values[2 * k]);
    EXPECT_EQ(found[k][1], values[2 * k + 1]);
  }
}

TEST_F(NpyRowsTest, RefusesWhatAreNoPoints) {
  const std::string whole = npy_header({2, 2}) + doubles({1, 2, 3, 4});
  EXPECT_EQ(rows(whole).size(), 2u);
  for (std::size_t size = 8; size < whole.size(); ++size) EXPECT_THROW(rows(whole.substr(0, size)), InputError) << size;
  EXPECT_THROW(rows(whole + "x"), InputError);
  EXPECT_THROW(rows(npy_header({2, 5}) + doubles(std::vector<double>(10))), InputError);
  EXPECT_THROW(rows(npy_header({2, 2, 2}) + doubles(std::vector<double>(8))), InputError);
  EXPECT_THROW(rows(npy_header({0, 2})), InputError);
  EXPECT_THROW(rows(npy_header({1, 2}) + doubles({1, NAN})), InputError);
  EXPECT_THROW(rows(npy_header({1}, {"X", "weight"}) + doubles({1, 2})), InputError);
  EXPECT_THROW(rows(npy_header({1}, {"X", "X"}) + doubles({1, 2})), InputError);
}

}  // namespace
}  // namespace assay::drivers::test_npy
