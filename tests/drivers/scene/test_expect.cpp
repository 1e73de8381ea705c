// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/expect.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/result/result_json.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_expect {
namespace {

std::vector<Expectation> lines(const std::string& map) { return read_expectations(read_yaml(map, "f")); }

Result sample() {
  Result result;
  result.outcome = "unstable";
  result.error.l2_max = 0.5;
  result.error.velocity.l2_max = NAN;
  result.steps = 200;
  return result;
}

bool holds(const std::string& line) {
  const auto judged = judge(lines("{" + line + "}"), sample());
  EXPECT_EQ(judged.size(), 1u);
  return judged.at(0).holds;
}

TEST(Expect, Operators) {
  EXPECT_TRUE(holds("error.l2_max: {below: 0.6}"));
  EXPECT_FALSE(holds("error.l2_max: {below: 0.5}"));
  EXPECT_TRUE(holds("error.l2_max: {above: 0.4}"));
  EXPECT_FALSE(holds("error.l2_max: {above: 0.5}"));
  EXPECT_TRUE(holds("error.l2_max: {between: [0.5, 0.5]}"));
  EXPECT_FALSE(holds("error.l2_max: {between: [0.51, 1]}"));
  EXPECT_FALSE(holds("error.l2_max: {between: [0, 0.49]}"));
  EXPECT_TRUE(holds("error.l2_max: {equals: 0.5}"));
  EXPECT_TRUE(holds("steps: 200"));
  EXPECT_FALSE(holds("steps: 201"));
  EXPECT_TRUE(holds("outcome: unstable"));
  EXPECT_TRUE(holds("outcome: {equals: unstable}"));
  EXPECT_FALSE(holds("outcome: completed"));
}

TEST(Expect, WhatWasNotReachedOrIsNoNumberHoldsNothing) {
  for (const char* key : {"error.l2_end", "error.velocity.l2_max", "sheet.error_tau"}) {
    for (const char* line :
         {": {below: 1e300}", ": {above: -1e300}", ": {between: [-1e300, 1e300]}", ": {equals: 0}"}) {
      EXPECT_FALSE(holds(std::string(key) + line)) << key << line;
    }
  }
  EXPECT_FALSE(holds("reason: ''"));
}

TEST(Expect, SaysWhatWasExpectedAndFound) {
  const auto judged = judge(
      lines("{error.l2_max: {below: 0.07}, outcome: completed, error.l2_end: {between: [1, 2]}, t: 3}"), sample());
  ASSERT_EQ(judged.size(), 4u);
  EXPECT_EQ(judged[0].key, "error.l2_max");
  EXPECT_EQ(judged[0].expected, "below 0.07");
  EXPECT_EQ(judged[0].found, "0.5");
  EXPECT_EQ(judged[1].expected, "completed");
  EXPECT_EQ(judged[1].found, "unstable");
  EXPECT_EQ(judged[2].expected, "between 1 and 2");
  EXPECT_EQ(judged[2].found, "null");
  EXPECT_EQ(judged[3].expected, "equals 3");
}

bool is_text_figure(const std::string& key) { return figure_of_result(key).kind == Field::Kind::text; }

TEST(Expect, EveryKeyOfTheResultMayBeAskedFor) {
  for (const std::string& key : flat_keys()) {
    const bool is_truth = figure_of_result(key).kind == Field::Kind::truth;
    const std::string value = is_truth               ? "true"
                              : !is_text_figure(key) ? "{below: 1}"
                              : key == "outcome"     ? "refused"
                                                     : "words";
    EXPECT_EQ(refusal_of([&] { lines("{" + key + ": " + value + "}"); }), "accepted") << key;
  }
  // The table of text keys agrees with the result: none that is text is asked as a number.
  Result full = sample();
  full.reason = "because";
  for (const auto& [key, value] : flatten(full)) {
    if (!std::holds_alternative<std::monostate>(value)) {
      EXPECT_EQ(std::holds_alternative<std::string>(value), is_text_figure(key)) << key;
    }
  }
}

TEST(Expect, TrueAndFalseAreValues) {
  EXPECT_TRUE(holds("uses_exact_solution: false"));
  EXPECT_TRUE(holds("uses_exact_solution: {equals: false}"));
  EXPECT_FALSE(holds("uses_exact_solution: true"));
  EXPECT_FALSE(holds("sheet.cached: true")) << "no sheet: null";
  Result cached = sample();
  cached.sheet.emplace().cached = true;
  const auto judged = judge(lines("{sheet.cached: true, uses_exact_solution: {equals: true}}"), cached);
  EXPECT_TRUE(judged[0].holds);
  EXPECT_EQ(judged[1].expected + ", " + judged[1].found, "true, false");
  EXPECT_EQ(expectation_yaml(lines("{sheet.cached: {equals: false}}")[0]), "false");
}

TEST(Expect, WhatIsNeitherTrueNorFalseIsBadInput) {
  const auto refused = [](const std::string& value) {
    return refusal_of([&] { lines("{sheet.cached: " + value + "}"); });
  };
  EXPECT_EQ(refused("read"), "f:1:16: expect.sheet.cached: must be true or false, found 'read'");
  EXPECT_EQ(refused("1"), "f:1:16: expect.sheet.cached: must be true or false, found '1': write true");
  EXPECT_EQ(refused("[true]"), "f:1:16: expect.sheet.cached: must be true or false, found a list");
  EXPECT_EQ(refused("{equals: 0}"), "f:1:25: expect.sheet.cached: must be true or false, found '0': write false");
  EXPECT_EQ(refused("{}"), "f:1:16: expect.sheet.cached: must be true, false, {equals: true} or {equals: false}");
  EXPECT_EQ(refused("{below: 1}"), "f:1:17: expect.sheet.cached.below: unknown key; known: equals");
}

TEST(Expect, UnknownKeysAreBadInput) {
  const std::string line = refusal_of([] { lines("{error.l2_mx: {below: 1}}"); });
  EXPECT_TRUE(line.starts_with("f:1:2: expect.error.l2_mx: unknown key (nearest: error.l2_max); known: error.l2_max, "))
      << line;
  EXPECT_NE(line.find(" more, which `assay schema` lists"), line.npos) << line;
  EXPECT_LT(line.size(), 300u) << line;
  EXPECT_TRUE(
      refusal_of([] { lines("{error: {l2_max: {below: 1}}}"); }).starts_with("f:1:2: expect.error: unknown key"));
}

Result with_response(double error_tau, Figure error_dtau, double asked = 1e-5) {
  Result result = sample();
  result.sheet = SheetFigures{};
  result.sheet->error_tau = error_tau, result.sheet->error_dtau = error_dtau, result.sheet->asked = asked;
  return result;
}

/// "FAILED KEY, EXPECTED", one a line.
std::string failed(const std::vector<ExpectationOutcome>& all) {
  std::string text;
  for (const ExpectationOutcome& one : all)
    text += one.holds ? "" : one.key + " " + one.expected + ", " + one.found + "\n";
  return text;
}

TEST(Expect, AResponseThatMissesByOrdersOfMagnitudeFails) {
  EXPECT_EQ(failed(judge({}, with_response(1e-4, 0.049))), "") << "missed, and stated";
  EXPECT_EQ(failed(judge({}, with_response(1e-6, 1.2))), "sheet.error_dtau below 0.05, as of any response, 1.2\n");
  EXPECT_EQ(failed(judge({}, with_response(0.06, std::nullopt))),
            "sheet.error_tau below 0.05, as of any response, 0.06\n");
  EXPECT_EQ(failed(judge({}, with_response(NAN, 0.01))).substr(0, 15), "sheet.error_tau");
  EXPECT_EQ(failed(judge({}, with_response(0.9, 0.9, 0.01))), "") << "a hundred times what was asked";
  EXPECT_EQ(failed(judge({}, sample())), "") << "no response";
}

TEST(Expect, ALineOfTheSceneTakesThePlaceOfThatOfAnyResponse) {
  const auto judged = judge(lines("{sheet.error_dtau: {below: 2}}"), with_response(1e-6, 1.2));
  ASSERT_EQ(judged.size(), 1u);
  EXPECT_TRUE(judged[0].holds);
  EXPECT_EQ(failed(judge(lines("{sheet.error_dtau: {below: 1}}"), with_response(0.3, 1.2))),
            "sheet.error_dtau below 1, 1.2\nsheet.error_tau below 0.05, as of any response, 0.3\n");
}

}  // namespace
}  // namespace assay::drivers::test_expect
