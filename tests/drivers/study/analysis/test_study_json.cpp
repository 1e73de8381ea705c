// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/study_json.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_study_json {
namespace {

using StudyTree = nlohmann::ordered_json;

/// The error's line; empty where the text is read.
std::string refusal_of_study(const std::string& text) {
  try {
    findings_of_json(text, "s.json");
  } catch (const InputError& error) {
    const std::string line = error.what();
    EXPECT_TRUE(line.starts_with("s.json")) << line;
    EXPECT_EQ(line.find('\n'), line.npos);
    return line;
  }
  return {};
}

/// The refusal of the sample with the value at that pointer replaced; null takes it out.
std::string refusal_with(const std::string& pointer, const StudyTree& value) {
  StudyTree tree = StudyTree::parse(study_json(two_method_study()));
  tree.at(StudyTree::json_pointer(pointer)) = value;
  return refusal_of_study(tree.dump());
}

TEST(StudyJson, IsReadBack) {
  const std::string text = study_json(two_method_study());
  const StudyFindings found = findings_of_json(text, "s.json");
  EXPECT_EQ(study_json(found), text);
  ASSERT_EQ(found.cases.size(), 10u);
  EXPECT_EQ(found.cases[2].values[1].value, "0.025");
  EXPECT_EQ(found.cases[2].history[1][1], 1.0 / 3);
  EXPECT_EQ(found.cases[2].clock.step_s, two_method_study().cases[2].clock.step_s);
  EXPECT_TRUE(found.cases[7].figures == two_method_study().cases[7].figures);
  EXPECT_EQ(found.series[0].asymptotic, StudySeries::Range::reached);
  EXPECT_EQ(found.series[0].fit->lower, 1.99);
  EXPECT_FALSE(found.series[1].fit);
  EXPECT_EQ(found.digits[2].best, 5u);
  EXPECT_FALSE(found.digits[3].best);
  EXPECT_EQ(found.expect[0].outcome.expected, "below 0.01");
  EXPECT_EQ(found.provenance.libraries, two_method_study().provenance.libraries);
  EXPECT_EQ(found.study_yaml, "title: Two methods\n");
}

TEST(StudyJson, AnEmptyStudyHasEveryKey) {
  const std::string text = study_json({});
  EXPECT_EQ(study_json(findings_of_json(text, "s.json")), text);
  EXPECT_EQ(StudyTree::parse(text).size(), StudyTree::parse(study_json(two_method_study())).size());
}

TEST(StudyJson, NumbersAreTheSameBitForBit) {
  std::mt19937_64 random(1);
  StudyFindings found;
  found.cases.resize(1);
  std::vector<double>& numbers = found.cases[0].clock.step_s;
  numbers = {0.0, -0.0, 5, 0.1, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), 1e22};
  while (numbers.size() < 5000) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) numbers.push_back(number);
  }
  const std::vector<double> back = findings_of_json(study_json(found), "s.json").cases[0].clock.step_s;
  ASSERT_EQ(back.size(), numbers.size());
  for (std::size_t i = 0; i < back.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(back[i]), std::bit_cast<std::uint64_t>(numbers[i])) << numbers[i];
}

TEST(StudyJson, WhatIsNotFiniteIsNull) {
  StudyFindings found = two_method_study();
  found.cases[6].error = std::numeric_limits<double>::infinity();
  found.cases[6].history = {{0.1, std::numeric_limits<double>::quiet_NaN()}};
  found.cases[6].reason = "bytes that are no UTF-8: \xff";
  const StudyFindings back = findings_of_json(study_json(found), "s.json");
  EXPECT_FALSE(back.cases[6].error);
  EXPECT_TRUE(std::isnan(back.cases[6].history[0][1]));
}

TEST(StudyJson, TornTextsAreRefused) {
  const std::string text = study_json(two_method_study());
  for (std::size_t length = 0; length + 2 < text.size(); length += 97)
    EXPECT_NE(refusal_of_study(text.substr(0, length)).find("is torn"), std::string::npos) << length;
  EXPECT_EQ(refusal_of_study("{\n  \"a\": 1,\n  oops"), "s.json:3:3: is no JSON");
  EXPECT_EQ(refusal_of_study("not json"), "s.json:1:2: is no JSON");
  EXPECT_EQ(refusal_of_study(text + "}"),
            "s.json:" + std::to_string(std::count(text.begin(), text.end(), '\n') + 1) + ":1: is no JSON");
  EXPECT_NE(refusal_of_study("[1e999]").find("is no study.json"), std::string::npos);
  EXPECT_NE(refusal_of_study(std::string(200000, '[')).find("too deep"), std::string::npos);
  EXPECT_NE(refusal_of_study(std::string("{\"a\": \"\xff\"}")).find("is no JSON"), std::string::npos);
}

TEST(StudyJson, OtherFilesAreRefused) {
  for (const char* text :
       {"{}", "[]", "null", "5", "\"assay study\"", "{\"format\": 1}", "{\"outcome\": \"completed\"}"})
    EXPECT_EQ(refusal_of_study(text), "s.json: is no study.json") << text;
  EXPECT_EQ(refusal_of_study("{\"format\": \"assay study\"}"), "s.json: has no key 'version'");
  EXPECT_EQ(refusal_with("/version", 2), "s.json: version: must be 1, found 2");
  EXPECT_EQ(refusal_with("/version", "1"), "s.json: version: must be 1, found \"1\"");
}

TEST(StudyJson, RefusalsSayWhere) {
  EXPECT_EQ(refusal_with("/cases/3/error", "small"), "s.json: cases[3].error: must be a number or null");
  EXPECT_EQ(refusal_with("/cases/0/number", -1), "s.json: cases[0].number: must be a whole number, not below 0");
  EXPECT_EQ(refusal_with("/series/0/cases/1", 10), "s.json: series[0].cases[1]: is no case: 10 of 10");
  EXPECT_EQ(refusal_with("/front/0", 1e3), "s.json: front[0]: must be a whole number, not below 0");
  EXPECT_EQ(refusal_with("/front/0", 6), "s.json: front: names a case without error or cost");
  EXPECT_EQ(refusal_with("/digits/0/best", 99), "s.json: digits[0].best: is no case: 99 of 10");
  EXPECT_EQ(refusal_with("/series/1/asymptotic", "yes"),
            "s.json: series[1].asymptotic: must be reached, not_reached or unknown");
  EXPECT_EQ(refusal_with("/series/1/pairwise", StudyTree::array()),
            "s.json: series[1].pairwise: must be as long as cases");
  EXPECT_NE(refusal_with("/cases/6/eligible", true), "");
  for (const char* key : {"cost", "error", "work"}) {
    EXPECT_EQ(refusal_with("/cases/0/" + std::string(key), -1),
              "s.json: cases[0]." + std::string(key) + ": must not be negative");
  }
  EXPECT_TRUE(refusal_with("/cases/0/outcome", "wonderful")
                  .starts_with("s.json: cases[0].outcome: is no outcome: 'wonderful'; known: completed, "));
  const std::size_t second = two_method_study().cases[1].number;
  EXPECT_EQ(refusal_with("/cases/0/number", second), "s.json: cases: holds case " + std::to_string(second) + " twice");
  EXPECT_NE(refusal_with("/cases/2/history/0", StudyTree::array({1})), "");
}

void paths_of(const StudyTree& tree, const std::string& path, std::vector<std::string>& paths) {
  if (!path.empty()) paths.push_back(path);
  if (!tree.is_structured()) return;
  for (const auto& item : tree.items()) paths_of(item.value(), path + "/" + item.key(), paths);
}

// Every value replaced by every kind of value, and every key taken away: read or refused, nothing else.
TEST(StudyJson, HostileTextsDoNotCrash) {
  const StudyTree whole = StudyTree::parse(study_json(two_method_study()));
  std::vector<std::string> paths;
  paths_of(whole, "", paths);
  const std::vector<StudyTree> kinds{nullptr,
                                     true,
                                     -1,
                                     1e300,
                                     std::uint64_t(-1),
                                     "x",
                                     StudyTree::array(),
                                     StudyTree::object(),
                                     StudyTree::array({StudyTree::object()})};
  std::size_t refused = 0;
  for (const std::string& path : paths) {
    if (path.find("/cases/") == 0 && path.find("/cases/2") != 0 && path.find("/cases/7") != 0) continue;
    const StudyTree::json_pointer at(path);
    for (const StudyTree& kind : kinds) {
      StudyTree tree = whole;
      tree[at] = kind;
      if (!refusal_of_study(tree.dump()).empty()) ++refused;
    }
    StudyTree tree = whole;
    if (!tree[at.parent_pointer()].is_object()) continue;
    tree[at.parent_pointer()].erase(at.back());
    if (!refusal_of_study(tree.dump()).empty()) ++refused;
  }
  EXPECT_GT(refused, paths.size());
}

}  // namespace
}  // namespace assay::drivers::test_study_json
