// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_writer.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/text/numbers.hpp"
#include "tests/support/kept_yaml.hpp"

namespace assay::drivers::test_yaml_writer {
namespace {

/// A number to readers of YAML 1.1 and of YAML 1.2: a point and a sign where there is an exponent, no zero in front.
bool is_number_to_all(const std::string& text) {
  static const std::regex form(
      "-?(0|[1-9][0-9]*)|-?(0|[1-9][0-9]*)\\.[0-9]+|-?[1-9]\\.[0-9]+e[-+][1-9][0-9]*|-?\\.inf|\\.nan");
  return std::regex_match(text, form);
}

/// The digits that count.
std::string digits_of(const std::string& number) {
  std::string digits;
  for (const char c : number.substr(0, number.find('e'))) {
    if (c >= '0' && c <= '9' && !(c == '0' && digits.empty())) digits += c;
  }
  while (digits.ends_with('0')) digits.pop_back();
  return digits;
}

void expect_number(double value) {
  const std::string text = yaml_number(value);
  EXPECT_TRUE(is_number_to_all(text)) << text;
  const auto back = parse_number(text);
  ASSERT_TRUE(back) << text;
  if (std::isnan(value)) {
    EXPECT_TRUE(std::isnan(*back)) << text;
    return;
  }
  EXPECT_EQ(std::bit_cast<std::uint64_t>(*back), std::bit_cast<std::uint64_t>(value)) << text;
  EXPECT_LE(digits_of(text).size(), digits_of(number_text(value)).size()) << text << " for " << number_text(value);
}

/// Any bits at all, numbers of usual size, and powers of ten with few digits.
std::vector<double> many_numbers() {
  std::vector<double> values{0.0,
                             -0.0,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::epsilon()};
  std::mt19937_64 random(7);
  for (int k = 0; k < 10000; ++k) values.push_back(std::bit_cast<double>(random()));
  std::uniform_real_distribution<double> usual(-1e4, 1e4);
  for (int k = 0; k < 1000; ++k) values.push_back(usual(random));
  for (int power = -30; power <= 30; ++power) {
    for (const double digits : {1.0, 1.5, 123.0, -7.0}) values.push_back(digits * std::pow(10.0, power));
  }
  return values;
}

TEST(YamlWriter, NumbersReadBackToTheBitAndAreNumbersToEveryReader) {
  for (const double value : many_numbers()) expect_number(value);
  EXPECT_EQ(yaml_number(std::numeric_limits<double>::infinity()), ".inf");
  EXPECT_EQ(yaml_number(-std::numeric_limits<double>::infinity()), "-.inf");
  EXPECT_EQ(yaml_number(std::numeric_limits<double>::quiet_NaN()), ".nan");
}

TEST(YamlWriter, FormOfNumbers) {
  const std::vector<std::pair<double, std::string>> known{
      {0, "0"},         {-0.0, "-0.0"},      {1, "1"},           {-1.5, "-1.5"},      {1000, "1000"},  {1e5, "100000"},
      {1e6, "1.0e+6"},  {2.1e11, "2.1e+11"}, {1e22, "1.0e+22"},  {0.25, "0.25"},      {1e-3, "0.001"}, {1e-4, "0.0001"},
      {1e-5, "1.0e-5"}, {1.5e-8, "1.5e-8"},  {-1e-8, "-1.0e-8"}, {5e-324, "5.0e-324"}};
  for (const auto& [value, text] : known) EXPECT_EQ(yaml_number(value), text);
}

TEST(YamlWriter, TheFormIsNoTautology) {
  for (const char* text : {"1e3", "1.0e3", "1e+3", "1.e+3", "1e-08", "1.0e-08", "010", ".5", "+1", "inf", "-nan", ""}) {
    EXPECT_FALSE(is_number_to_all(text)) << text;
  }
}

const std::vector<std::string> plain_texts{"plain", "neo_hookean", "rel/path.so", "/abs/path", "a.b-c", "e3",
                                           "nan",   "inf",         "x1e3",        "north",     "None",  "error.l2_max"};

/// To YAML 1.1, to YAML 1.2 or to both something else than text.
const std::vector<std::string> other_values{"",       "~",      "null",       "Null",
                                            "NULL",   "true",   "True",       "TRUE",
                                            "false",  "False",  "FALSE",      "yes",
                                            "Yes",    "YES",    "no",         "No",
                                            "NO",     "on",     "On",         "ON",
                                            "off",    "Off",    "OFF",        "y",
                                            "Y",      "n",      "N",          "1",
                                            "-1",     "+1",     "010",        "0o10",
                                            "0x1f",   "0b1",    "1_000",      "1:30",
                                            "1:30.5", "1.5",    ".5",         "1.",
                                            "1e3",    "1.0e+3", "1e-08",      ".inf",
                                            "-.inf",  ".nan",   ".NaN",       "=",
                                            "<<",     "-",      "2001-12-14", "2001-12-14 21:59:43",
                                            "1e400"};

const std::vector<std::string> odd_texts{"two words",
                                         "a: b",
                                         "# x",
                                         "- x",
                                         "*x",
                                         "&x",
                                         "!x",
                                         "'",
                                         "\"",
                                         "\\",
                                         "\\n",
                                         "tab\there",
                                         "line\nbreak",
                                         "bell\x07",
                                         "del\x7f",
                                         "\xc3\xa9",
                                         "{a}",
                                         "[a]",
                                         "a,b",
                                         "%x",
                                         "@x",
                                         "`x",
                                         "|",
                                         ">",
                                         " lead",
                                         "trail ",
                                         "/a.so:name",
                                         "...",
                                         "---",
                                         "?",
                                         ":",
                                         "\r\n",
                                         "a\xc2\x85"
                                         "b",
                                         "a\xc2\x9f"
                                         "b",
                                         "a\xe2\x80\xa8"
                                         "b",
                                         "a\xe2\x80\xa9"
                                         "b",
                                         "\xef\xbb\xbf"
                                         "b",
                                         "a\xef\xbf\xbe"
                                         "b",
                                         "a\xef\xbf\xbf"
                                         "b",
                                         "\xf0\x9f\x8c\x80",
                                         "\xc2\xa0"};

std::vector<std::string> all_texts() {
  std::vector<std::string> all = plain_texts;
  for (const auto* more : {&other_values, &odd_texts}) all.insert(all.end(), more->begin(), more->end());
  return all;
}

TEST(YamlWriter, ScalarsReadBack) {
  for (const std::string& text : all_texts()) {
    const Tree tree = read_yaml("k: " + yaml_scalar(text) + "\n", "f");
    EXPECT_EQ(tree.find("k")->kind, Tree::Kind::scalar) << text;
    EXPECT_EQ(tree.find("k")->text, text);
    EXPECT_EQ(read_yaml(yaml_scalar(text) + ": 1\n", "f").entries.at(0).key, text);
  }
}

TEST(YamlWriter, TextIsQuotedWhereAReaderWouldTakeItForMore) {
  for (const std::string& text : plain_texts) EXPECT_EQ(yaml_scalar(text), text);
  for (const std::string& text : other_values) {
    EXPECT_TRUE(yaml_scalar(text).starts_with('"')) << text;
  }
}

// What stands as it is in double quotes, others might take for an end of a line, or refuse.
TEST(YamlWriter, CharactersThatReadersTakeDifferentlyAreEscaped) {
  EXPECT_EQ(yaml_scalar("a\xc2\x85"
                        "b"),
            "\"a\\x85b\"");
  EXPECT_EQ(yaml_scalar("\xe2\x80\xa8\xe2\x80\xa9"), "\"\\u2028\\u2029\"");
  EXPECT_EQ(yaml_scalar("\xef\xbb\xbf"), "\"\\ufeff\"");
  EXPECT_EQ(yaml_scalar("\xc3\xa9\xe2\x80\xa6"), "\"\xc3\xa9\xe2\x80\xa6\"");
}

// Other readers are asked by tests/yaml/check_yaml.py.
TEST(YamlWriter, LeavesItsTextsAndNumbersForOtherReaders) {
  std::string yaml = "texts:\n";
  nlohmann::ordered_json json;
  for (const std::string& text : all_texts()) {
    yaml += "  - " + yaml_scalar(text) + "\n";
    json["texts"].push_back(text);
  }
  yaml += "keys:\n";
  for (const std::string& text : all_texts()) {
    yaml += "  " + yaml_scalar(text) + ": 1\n";
    json["keys"][text] = 1;
  }
  yaml += "numbers:\n";
  for (const double value : many_numbers()) {
    if (!std::isfinite(value)) continue;
    yaml += "  - " + yaml_number(value) + "\n";
    json["numbers"].push_back(value);
  }
  keep_yaml("values", yaml, json.dump());
}

}  // namespace
}  // namespace assay::drivers::test_yaml_writer
