// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/csv.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"

namespace assay::drivers::test_csv {
namespace {

std::string refusal(std::string_view text) {
  try {
    read_csv(text, "p.csv", {"X", "t"}, {"Z"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refusal(std::string_view text, const std::string& start, const std::string& part) {
  const std::string what = refusal(text);
  EXPECT_TRUE(what.starts_with(start)) << what;
  EXPECT_NE(what.find(part), std::string::npos) << what;
  EXPECT_EQ(what.find('\n'), std::string::npos);
}

TEST(Csv, writes_what_reads_back_the_same) {
  CsvText out({"X", "t"});
  const std::array<double, 4> values{0.1, -1e-300, std::nextafter(1.0, 2.0), 12345678.9};
  for (const double value : values) out.row(std::array{value, 1 / value});
  const CsvTable table = read_csv(out.text(), "p.csv", {"t", "X"});
  ASSERT_EQ(table.rows(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ((*table.column("X"))[i], values[i]);
    EXPECT_EQ((*table.column("t"))[i], 1 / values[i]);
  }
  EXPECT_EQ(table.column("Z"), nullptr);
}

TEST(Csv, writes_null_as_an_empty_field) {
  CsvText out({"a", "b", "c"});
  out.row(std::array{0.5, std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()});
  EXPECT_EQ(out.text(), "a,b,c\n0.5,,\n");
}

TEST(Csv, reads_any_order_comments_blank_lines_and_crlf) {
  const CsvTable table =
      read_csv("\xEF\xBB\xBF# points\r\n\r\n t , X \r\n 1e-3, +2 \r\n# more\r\n-0.5,.25", "p", {"X", "t"});
  EXPECT_EQ(*table.column("X"), (std::vector<double>{2, 0.25}));
  EXPECT_EQ(*table.column("t"), (std::vector<double>{1e-3, -0.5}));
  EXPECT_EQ(table.lines, (std::vector<int>{4, 6}));
  EXPECT_EQ(table.header_line, 3);
}

TEST(Csv, refuses_with_the_place) {
  expect_refusal("X,t\n1,2\n1,nan\n", "p.csv:3:3: ", "t: 'nan' is no finite number");
  expect_refusal("X,t\n1,1e-400\n", "p.csv:2:3: ", "t: '1e-400' is no finite number: smaller than a number can be");
  expect_refusal("X,t\n1,1.0D0\n", "p.csv:2:3: ", "t: '1.0D0' is no finite number: ");
  expect_refusal("X,t\n1,\n", "p.csv:2:3: ", "is no finite number: a field of each row must have one");
  expect_refusal("X,t\n1,.nan\n", "p.csv:2:3: ", "finite");
  expect_refusal("X,t\n1,.inf\n", "p.csv:2:3: ", "finite");
  expect_refusal("X,t\n1,1e999\n", "p.csv:2:3: ", "finite");
  expect_refusal("X,t\n1,  0x10\n", "p.csv:2:5: ", "'0x10'");
  expect_refusal("X,t\n1,\n", "p.csv:2:3: ", "''");
  expect_refusal("X,t\n1\n", "p.csv:2:1: ", "1 field, separated by a comma, where the header names 2");
  expect_refusal("X,t\n1,2,3\n", "p.csv:2:5: ", "3 fields");
  expect_refusal("X,Y,t\n1,2,3\n", "p.csv:1:3: ", "'Y'");
  expect_refusal("X,t,X\n1,2,3\n", "p.csv:1:5: ", "twice");
  expect_refusal("X,Z\n1,2\n", "p.csv:1:1: ", "no column 't'; columns are separated by a comma in this file");
  expect_refusal("Z\n2\n", "p.csv:1:1: ", "no columns 'X', 't'");
  expect_refusal("1,2\n", "p.csv:1:1: ", "'1'");
}

std::vector<std::vector<double>> columns_of(std::string_view text) {
  const CsvTable table = read_csv(text, "p.csv", {"X", "t"});
  return {*table.column("X"), *table.column("t")};
}

TEST(Csv, reads_what_spreadsheets_export) {
  const std::vector<std::vector<double>> expected{{0.5, -1}, {2, 1000}};
  for (const std::string_view text :
       {"\"X\",\"t\"\n0.5,2\n-1,1e3\n", "X;t\n0.5;2\n-1;1e3\n", "X\tt\n0.5\t2\n-1\t1e3\n",
        "X;t\r\n0,5;2,0\r\n-1;1,0e3\r\n", "\"X\"\t\"t\"\n0,5\t2\n-1\t1000\n", "X,t\n\"0,5\",\"2\"\n-1,1000\n",
        "sep=;\nX;t\n0,5;2\n-1;1000\n", "sep=|\nX|t\n0.5|2\n-1|1000\n", "X;t\r0,5;2\r-1;1000\r",
        "X,t,\n0.5,2,\n-1,1e3,\n", "X;t;\r\n0,5;2;\r\n-1;1000\r\n", "X\tt\t\n0.5\t2\t\n-1\t1e3\t\n",
        "# it's \"mine\nX ; t\n 0.5 ; 2\n'-1;1000\n"}) {
    EXPECT_EQ(columns_of(text), expected) << text;
  }
}

TEST(Csv, refuses_what_can_mean_two_things) {
  const std::string mixed = "a decimal comma and a decimal point in one file";
  expect_refusal("X;t\n0,5;2.5\n", "p.csv:2:5: ", mixed);
  expect_refusal("X;t\n0.5;1\n1;0,5\n", "p.csv:3:3: ", mixed);
  const std::string thousands = "has a comma and a point: thousands are not separated";
  expect_refusal("X;t\n1.000,5;1\n", "p.csv:2:1: ", thousands);
  expect_refusal("X,t\n\"1,000.5\",1\n", "p.csv:2:1: ", thousands);
  expect_refusal("X,t [s]\n1,2\n", "p.csv:1:3: ", "column 't [s]': the name alone, 't', without its unit");
  expect_refusal("X(m),t\n1,2\n", "p.csv:1:1: ", "the name alone, 'X', without its unit");
  expect_refusal("sep=;\nX,Y,t\n1,2,3\n",
                 "p.csv:2:1: ", "unknown column 'X,Y,t', separated by a semicolon in this file");
  expect_refusal("X,t\n1,.5 # here\n", "p.csv:2:3: ", "only a line that begins with '#' is a remark");
  expect_refusal("X,t,,\n1,2,,\n", "p.csv:1:5: ", "a column without a name");
  expect_refusal("X,t\n0,5,1,5\n", "p.csv:2:7: ", "with decimal commas, separate by semicolons");
  expect_refusal("X t\n1 2\n", "p.csv:1:1: ", "columns are separated by a comma, a semicolon or a tab");
  expect_refusal("X;t\n1;2;3\n", "p.csv:2:5: ", "3 fields, separated by a semicolon");
  expect_refusal("X;t\n1,5,2;3\n", "p.csv:2:1: ", "'1,5,2' is no finite number, separated by a semicolon");
  expect_refusal("\"X,t\n1,2\n", "p.csv:1:1: ", "a quote that is not closed");
  expect_refusal("\"X\"Y,t\n1,2\n", "p.csv:1:4: ", "text behind a closing quote");
  expect_refusal("\xFF\xFEX", "p.csv:1:1: ", "UTF-16 text: save it as UTF-8");
  for (const std::string& text : {std::string("X\0,\0Y\0", 6), std::string("\0X\0,\0Y", 6)})
    expect_refusal(text, "p.csv:1:1: ", "UTF-16 text: save it as UTF-8");
  expect_refusal("1;2\n3;4\n", "p.csv:1:1: ", "a number where names of columns belong");
  expect_refusal("X,T\n1,2\n", "p.csv:1:3: ", "unknown column 'T' (nearest: t)");
  expect_refusal("X,t\n1,2,\n", "p.csv:2:5: ", "3 fields");
  expect_refusal("X,t,\n1,2,3\n", "p.csv:2:5: ", "3 fields");
}

TEST(Csv, refuses_files_without_numbers) {
  expect_refusal("", "p.csv", "no header line");
  expect_refusal("# only this\n\n", "p.csv", "no header line");
  expect_refusal("X,t\n# none\n", "p.csv:2", "no row");
}

TEST(Csv, refuses_garbage_on_one_short_line) {
  const std::string what = refusal(std::string(100000, '\x01') + "\n");
  EXPECT_LT(what.size(), 500u);
  EXPECT_EQ(what.find('\x01'), std::string::npos);
}

TEST(Csv, unreadable_files_are_bad_input) {
  for (const char* file : {"/nonexistent/p.csv", "/tmp"}) {
    try {
      read_input_file(file);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::string(file) + ": ")) << error.what();
    }
  }
}

/// As a spreadsheet would take them; what they were is what our own reader finds.
TEST(CsvFields, that_look_like_formulas_are_kept_texts) {
  const std::vector<std::string> labels{"=1+1", "+cmd", "-x", "@sum(A1)", "\t=1", "plain", "'quoted", "a\nb\"c;d"};
  CsvText fields(labels);
  fields.row({"-0.5", "+2", "1e-3", "", "", "", "", ""});
  EXPECT_TRUE(fields.text().starts_with("'=1+1,'+cmd,'-x,'@sum(A1),\"'\t=1\",plain,'quoted,")) << fields.text();
  EXPECT_TRUE(fields.text().ends_with("\n-0.5,+2,1e-3,,,,,\n")) << "numbers are none";
  const std::string file = "f.csv";
  CsvLines lines(fields.text(), file);
  std::vector<std::string> found;
  const auto header = lines.next(), row = lines.next();
  ASSERT_TRUE(header && row);
  for (const CsvField& field : *header) found.push_back(field.text);
  EXPECT_EQ(found, labels);
  EXPECT_EQ(row->front().text, "-0.5");
  EXPECT_EQ(lines.line(), 3) << "a line break within a field";
}

TEST(CsvFields, are_quoted_where_they_must_be) {
  CsvText fields({"a", "b"});
  fields.row({"plain text", "one, \"two\"\nthree"});
  EXPECT_EQ(fields.text(), "a,b\nplain text,\"one, \"\"two\"\"\nthree\"\n");
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number({}), "");
  EXPECT_EQ(csv_number(INFINITY), "");
}

}  // namespace
}  // namespace assay::drivers::test_csv
