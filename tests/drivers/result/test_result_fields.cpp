// SPDX-License-Identifier: BSD-3-Clause
// What a result says of its figures: each has a text and a number its unit, and docs/results.md holds all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/result/result_json.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/support/renewal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_result_fields {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::vector<std::string>;

/// What is wrong with what is said of a field; empty where nothing is.
std::string fault_of(const Field& field) {
  const std::string meaning = field.meaning();
  if (meaning.empty() || (field.doc.empty() && field.name.empty())) return "no doc";
  if (meaning.find('\n') != meaning.npos || meaning.size() > 140) return "no short line";
  const bool is_number = field.kind == Field::Kind::number;
  if (is_number && field.unit.empty()) return "a number without unit";
  if (!is_number && !field.unit.empty()) return "a unit of what is no number";
  for (const auto& [end, unit] : {std::pair("_per_s", "1/s"), {"_s", "s"}, {"bytes", "B"}, {"seconds", "s"}}) {
    if (field.key.ends_with(end)) return field.unit == unit ? "" : "another unit than its name says";
  }
  return {};
}

TEST(ResultFields, EachHasADocAndANumberItsUnit) {
  ASSERT_GT(result_fields().size(), 80u);
  for (const Field& field : result_fields()) EXPECT_EQ(fault_of(field), "") << field.key;
}

struct Part {
  bool on = true;
  double speed = 1, wall_s = 1;
  static void fields(auto& self, auto& archive) {
    archive("on", self.on, "m", "whether it is on");
    archive("speed", self.speed, "", "how fast it is");
    archive("wall_s", self.wall_s, "1", "how long it takes");
  }
};

struct Whole {
  std::optional<Part> part;
  std::vector<Part> parts;
  double silent = 1;
  static void fields(auto& self, auto& archive) {
    archive.section("part", self.part);
    archive("parts", self.parts);
    archive("silent", self.silent);
  }
};

TEST(ResultFieldsNegativeControl, WhatIsNotSaidIsSeen) {
  FieldList archive;
  const Whole whole;
  Whole::fields(whole, archive);
  Lines found;
  for (const Field& field : archive.fields()) found.push_back(field.key + ": " + fault_of(field));
  const std::string unit = "a unit of what is no number", none = "a number without unit",
                    other = "another unit than its name says";
  EXPECT_EQ(found, (Lines{"part.on: " + unit, "part.speed: " + none, "part.wall_s: " + other, "parts[].on: " + unit,
                          "parts[].speed: " + none, "parts[].wall_s: " + other, "silent: no doc"}));
}

/// Paths of all leaves, in their order: "error.l2_max", "passes[].name".
void leaves(const Json& value, const std::string& path, Lines& found) {
  if (value.is_object()) {
    for (const auto& item : value.items()) leaves(item.value(), path + (path.empty() ? "" : ".") + item.key(), found);
  } else if (value.is_array() && !value.empty() && value[0].is_object()) {
    leaves(value[0], path + "[]", found);
  } else {
    found.push_back(path);
  }
}

TEST(ResultFields, AreThoseOfTheFileInItsOrder) {
  Result result;
  result.passes.resize(1), result.expect.resize(1), result.tractions.emplace().runs.resize(1);
  Lines in_file, described;
  leaves(Json::parse(result_json(result)), "", in_file);
  for (const Field& field : result_fields()) described.push_back(field.key);
  EXPECT_EQ(in_file, described);
}

std::string row_of(const Field& field) {
  std::string meaning = field.meaning();
  for (std::size_t at = 0; (at = meaning.find('|', at)) != meaning.npos; at += 2) meaning.insert(at, "\\");
  return "| `" + field.key + "` | " + field.unit + " | " + meaning + " |";
}

/// The page with a row for each figure: one that is missing stands behind that of the figure before it.
std::string with_rows(std::string page) {
  std::string before;
  for (const Field& field : result_fields()) {
    const std::string row = "\n" + row_of(field), key = "\n| `" + field.key + "` |";
    if (const std::size_t own = page.find(key); own != page.npos) {
      page.replace(own, page.find('\n', own + 1) - own, row);
    } else if (!before.empty()) {
      page.insert(page.find('\n', page.find(before) + 1), row);
    }
    before = key;
  }
  return page;
}

TEST(ResultFields, AreTheTablesOfThePage) {
  const std::string path = tree_folder() + "/docs/results.md";
  if (renews()) {
    const std::string renewed = with_rows(read_bytes(path));
    std::ofstream(path, std::ios::binary) << renewed;
  }
  const std::string page = read_bytes(path);
  EXPECT_EQ(with_rows(page), page) << "./dev renew writes these rows";
  const std::size_t begin = page.find("\n## result.json"), end = page.find("\n## ", begin + 1);
  ASSERT_LT(begin, end);
  std::istringstream section(page.substr(begin, end - begin));
  Lines rows, expected;
  for (std::string line; std::getline(section, line);) {
    if (line.starts_with("| `")) rows.push_back(line);
  }
  for (const Field& field : result_fields()) expected.push_back(row_of(field));
  std::sort(rows.begin(), rows.end()), std::sort(expected.begin(), expected.end());
  std::string missing, others;
  for (const std::string& row : expected)
    missing += std::binary_search(rows.begin(), rows.end(), row) ? "" : row + "\n";
  for (const std::string& row : rows)
    others += std::binary_search(expected.begin(), expected.end(), row) ? "" : row + "\n";
  EXPECT_EQ(missing, "") << "tables of docs/results.md, result.json, are to hold these rows";
  EXPECT_EQ(others, "") << "tables of docs/results.md, result.json, are not to hold these rows";
  EXPECT_EQ(rows.size(), expected.size());
}

}  // namespace
}  // namespace assay::drivers::test_result_fields
