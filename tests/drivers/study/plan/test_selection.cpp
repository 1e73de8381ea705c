// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_selection {
namespace {

Selection selection_in(const std::string& flow) { return read_selection(read_yaml(flow, "f"), "where"); }

bool selects(const std::string& flow, const std::vector<AxisValue>& values) { return selection_in(flow).holds(values); }

const std::vector<AxisValue> of_a_case{{"method", "CPDI, FLIP"}, {"grid.spacing", "0.05"}, {"body.per_cell", "[2, 2]"}};

TEST(Selection, EveryConditionMustHold) {
  EXPECT_TRUE(selects("{}", of_a_case));
  EXPECT_TRUE(selects("{}", {}));
  EXPECT_TRUE(selects("{method: 'CPDI, FLIP'}", of_a_case));
  EXPECT_TRUE(selects("{method: 'CPDI, FLIP', grid.spacing: 0.05}", of_a_case));
  EXPECT_FALSE(selects("{method: 'CPDI, FLIP', grid.spacing: 0.1}", of_a_case));
  EXPECT_FALSE(selects("{method: uGIMP, grid.spacing: 0.05}", of_a_case));
  EXPECT_FALSE(selects("{method: [CPDI, FLIP]}", of_a_case)) << "a list is of values, not one of them";
  EXPECT_TRUE(selects("{method: ['CPDI, FLIP', uGIMP]}", of_a_case));
  EXPECT_TRUE(selects("{body.per_cell: [[2, 2], [3, 3]]}", of_a_case));
}

TEST(Selection, NumbersAreComparedAsNumbers) {
  for (const char* same : {"0.05", "5.0e-2", "5E-2", "+0.050", ".05", "'0.05'"}) {
    EXPECT_TRUE(selects("{grid.spacing: " + std::string(same) + "}", of_a_case)) << same;
    EXPECT_FALSE(selects("{grid.spacing: {not: " + std::string(same) + "}}", of_a_case)) << same;
  }
  EXPECT_TRUE(same_value("1", "1.0"));
  EXPECT_TRUE(same_value("a", "a"));
  EXPECT_TRUE(same_value(".nan", ".nan"));
  EXPECT_TRUE(same_value("0", "-0.0"));
  EXPECT_FALSE(same_value("1", "1a"));
  EXPECT_FALSE(same_value("0x10", "16"));
  EXPECT_FALSE(same_value("0.05", "0.050000000000000003e1"));
  EXPECT_FALSE(same_value("A", "a"));
}

TEST(Selection, OperatorsHaveTheirBounds) {
  EXPECT_TRUE(selects("{grid.spacing: {below: 0.051}}", of_a_case));
  EXPECT_FALSE(selects("{grid.spacing: {below: 0.05}}", of_a_case));
  EXPECT_TRUE(selects("{grid.spacing: {above: 0.049}}", of_a_case));
  EXPECT_FALSE(selects("{grid.spacing: {above: 0.05}}", of_a_case));
  EXPECT_TRUE(selects("{grid.spacing: {between: [0.05, 0.05]}}", of_a_case));
  EXPECT_FALSE(selects("{grid.spacing: {between: [0.051, 1]}}", of_a_case));
  EXPECT_FALSE(selects("{grid.spacing: {between: [0, 0.049]}}", of_a_case));
  EXPECT_TRUE(selects("{grid.spacing: {not: 0.1}}", of_a_case));
  EXPECT_TRUE(selects("{grid.spacing: {not: [0.1, 0.2]}}", of_a_case));
  EXPECT_FALSE(selects("{grid.spacing: {not: [0.1, 0.05]}}", of_a_case));
  for (const char* none : {"{below: 1}", "{above: -1}", "{between: [-1, 1]}"}) {
    EXPECT_FALSE(selects("{method: " + std::string(none) + "}", of_a_case)) << "no number";
  }
}

TEST(Selection, ACaseWithoutAValueOnTheAxisFulfilsNoneOfAlone) {
  for (const char* none : {"1", "[1, 2]", "{below: 1}", "{above: -1}", "{between: [-1, 1]}"}) {
    EXPECT_FALSE(selects("{time.end: " + std::string(none) + "}", of_a_case)) << none;
  }
  EXPECT_TRUE(selects("{time.end: {not: 1}}", of_a_case));
}

TEST(Selection, WhatIsNoConditionIsRefused) {
  const std::pair<const char*, const char*> maps[] = {
      {"[a]",
       "f:1:1: where: must be a map of keys, found a list: its keys stand without '-' and brackets; known: axes of the "
       "study"},
      {"{a: {}}", "f:1:5: where.a: must hold exactly one operator; known: below, above, between, not"},
      {"{a: {below: 1, above: 0}}",
       "f:1:5: where.a: must hold exactly one operator; known: below, above, between, not"},
      {"{a: {equals: 1}}", "f:1:6: where.a.equals: unknown key; known: below, above, between, not"},
      {"{a: {beloww: 1}}", "f:1:6: where.a.beloww: unknown key (nearest: below); known: below, above, between, not"},
      {"{a: {below: b}}", "f:1:13: where.a.below: must be a number, found 'b'"},
      {"{a: {above: .nan}}", "f:1:13: where.a.above: must be a finite number, found '.nan'"},
      {"{a: {between: 1}}", "f:1:15: where.a.between: must be a list of 2 numbers, found '1': write [1, 1]"},
      {"{a: {between: [1]}}", "f:1:15: where.a.between: must be a list of 2 numbers, found 1 in it"},
      {"{a: {between: [1, b]}}", "f:1:19: where.a.between[1]: must be a number, found 'b'"},
      {"{a: {between: [2, 1]}}", "f:1:15: where.a.between: the first must not exceed the second"},
      {"{a: []}", "f:1:5: where.a: names no value"},
      {"{a: {not: []}}", "f:1:11: where.a.not: names no value"},
  };
  for (const auto& each : maps) EXPECT_EQ(refusal_of([&] { selection_in(each.first); }), each.second) << each.first;
}

TEST(Selection, KnowsWhereItStands) {
  const Selection selection = read_selection(read_yaml("a:\n  b: 1\n  c: {not: 2}\n", "f").entries[0].value, "where");
  EXPECT_EQ(selection.where.line, 2);
  ASSERT_EQ(selection.conditions.size(), 2u);
  EXPECT_EQ(selection.conditions[1].where.text(), "f:3:3");
  EXPECT_EQ(selection.conditions[1].kind, Condition::Kind::none_of);
}

TEST(Selection, AValueIsOneLineOfYaml) {
  const auto text_of = [](const std::string& yaml) {
    return flow_text(read_yaml("k: " + yaml + "\n", "f").entries.at(0).value);
  };
  EXPECT_EQ(text_of("0.05"), "0.05");
  EXPECT_EQ(text_of("'a b'"), "a b");
  EXPECT_EQ(text_of(""), "null");
  EXPECT_EQ(text_of("[1, [2,3], {a: b}]"), "[1, [2, 3], {a: b}]");
  EXPECT_EQ(text_of("{a: 1, 'b: c': [x]}"), "{a: 1, \"b: c\": [x]}");
  EXPECT_EQ(text_of("[]"), "[]");
  EXPECT_EQ(text_of("['', b]"), "[, b]") << "an empty item is one";
}

}  // namespace
}  // namespace assay::drivers::test_selection
