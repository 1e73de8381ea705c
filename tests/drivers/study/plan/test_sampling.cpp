// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "drivers/text/numbers.hpp"
#include "tests/drivers/study/study_text_fixture.hpp"

namespace assay::drivers::test_sampling {
namespace {

/// "a,x b,y": of each combination the values, without the names of the axes.
std::string values_in(const std::vector<Combination>& combinations) {
  std::string text;
  for (const Combination& one : combinations) {
    std::string values;
    for (const AxisValue& value : one.values) values += (values.empty() ? "" : ",") + value.value;
    text += (text.empty() ? "" : " ") + values;
  }
  return text;
}

std::vector<Combination> sampled_of(const std::string& text) { return combinations_of(StudyFolder().read(text)); }

/// The numbers on one axis, in the order of the cases.
std::vector<double> column_of(const std::vector<Combination>& all, std::size_t axis) {
  std::vector<double> numbers;
  for (const Combination& one : all) numbers.push_back(parse_number(one.values.at(axis).value).value());
  return numbers;
}

/// How often each of `count` equal parts of [0,1) is taken.
std::vector<int> parts_taken(const std::vector<double>& shares) {
  std::vector<int> taken(shares.size());
  for (const double share : shares) ++taken.at(static_cast<std::size_t>(share * static_cast<double>(shares.size())));
  return taken;
}

const std::string three_by_two =
    "axes: {method: {a: {method.basis: cpdi, threads: 2}, b: {}, c: {method.basis: ugimp}}, time.end: [1, 2]}\n";

TEST(Sampling, TheLastAxisOfAProductIsTheFastest) {
  const auto all = sampled_of(three_by_two);
  EXPECT_EQ(values_in(all), "a,1 a,2 b,1 b,2 c,1 c,2");
  ASSERT_EQ(all[1].settings.size(), 3u);
  EXPECT_EQ(all[1].values[1].axis, "time.end");
  EXPECT_EQ(all[1].settings[0].path, "method.basis");
  EXPECT_EQ(all[1].settings[1].path, "threads");
  EXPECT_EQ(all[1].settings[2].path, "time.end");
  EXPECT_EQ(all[1].settings[2].value.text, "2");
  ASSERT_EQ(all[2].settings.size(), 1u);
  EXPECT_EQ(values_in(sampled_of("axes: {time.end: [1]}\n")), "1");
}

TEST(Sampling, WhatIsExcludedIsNotThere) {
  EXPECT_EQ(
      values_in(sampled_of(three_by_two + "exclude: [{method: a, time.end: 2}, {method: [b, c], time.end: 1}]\n")),
      "a,1 b,2 c,2");
  EXPECT_EQ(values_in(sampled_of(three_by_two + "exclude: [{method: {not: b}}]\n")), "b,1 b,2");
  EXPECT_EQ(values_in(sampled_of(three_by_two + "exclude: []\n")), "a,1 a,2 b,1 b,2 c,1 c,2");
  const StudyFolder folder;
  for (const char* all : {"{}", "{time.end: {above: 0}}"}) {
    EXPECT_EQ(folder.shortened_line(
                  refusal_of([&] { combinations_of(folder.read(three_by_two + "exclude: [" + all + "]\n")); })),
              "study.yaml: exclude: leaves no case");
  }
}

TEST(Sampling, HugeProductsAreRefusedBeforeTheyAreMade) {
  std::string values;
  for (int i = 0; i < 317; ++i) values += (i == 0 ? "" : ",") + std::to_string(i);
  const StudyFolder folder;
  const auto refused = [&](const std::string& third) {
    const Study study = folder.read("axes:\n  body.seed: [" + values + "]\n  time.end: [" + values + "]\n" + third);
    return folder.shortened_line(refusal_of([&] { combinations_of(study); }));
  };
  EXPECT_EQ(refused(""), "study.yaml:4:3: axes: more than 100000 cases") << "317^2 = 100489";
  EXPECT_EQ(refused("  threads: [" + values + "]\n"), "study.yaml:4:3: axes: more than 100000 cases");
  const std::string hundred = values.substr(0, values.find(",100"));
  EXPECT_EQ(combinations_of(folder.read("axes: {body.seed: [" + hundred + "], time.end: [" + hundred + "]}\n")).size(),
            10000u);
}

TEST(Sampling, AListIsTakenAsItStands) {
  const auto all = sampled_of(
      "axes: {method: {a: {method.basis: cpdi}, b: {}}}\n"
      "sampling: list\n"
      "cases: [{time.end: 2, method: b}, {method: a}, {time.end: 1}, {time.end: 2.0, method: a}, {method: a}]\n"
      "exclude: [{time.end: 1}]\n");
  EXPECT_EQ(values_in(all), "b,2 a a,2 a") << "the axes in their order, a value that is the same by its first name";
  EXPECT_EQ(all[1].values[0].axis, "method");
  EXPECT_EQ(all[2].settings[1].path, "time.end");
}

const std::string spans =
    "axes: {time.end: {from: -1, to: 3}, grid.spacing: {from: 1.0e-3, to: 10, log: true}, method.basis: [cpdi, ugimp], "
    "body.seed: {from: 3, to: 22, whole: true}}\n";

TEST(Sampling, AHypercubeTakesEachPartOfEachAxisOnce) {
  for (const char* seed : {"1", "2", "77"}) {
    const auto all = sampled_of(spans + "sampling: {latin_hypercube: 20, seed: " + seed + "}\n");
    ASSERT_EQ(all.size(), 20u);
    std::vector<double> linear, logarithmic;
    for (const double value : column_of(all, 0)) linear.push_back((value + 1) / 4);
    for (const double value : column_of(all, 1)) logarithmic.push_back(std::log10(value / 1e-3) / 4);
    EXPECT_EQ(parts_taken(linear), std::vector<int>(20, 1));
    EXPECT_EQ(parts_taken(logarithmic), std::vector<int>(20, 1));
    int cpdi = 0;
    for (const Combination& one : all) cpdi += one.values[2].value == "cpdi" ? 1 : 0;
    EXPECT_EQ(cpdi, 10) << "levels are taken as often as one another";
    const auto seeds = column_of(all, 3);
    EXPECT_EQ(std::set<double>(seeds.begin(), seeds.end()).size(), 20u) << "20 whole numbers, 20 cases";
    EXPECT_EQ(*std::min_element(seeds.begin(), seeds.end()), 3);
    EXPECT_EQ(*std::max_element(seeds.begin(), seeds.end()), 22);
  }
}

TEST(Sampling, TheAxesOfAHypercubeAreShuffledApart) {
  const auto all = sampled_of(spans + "sampling: {latin_hypercube: 200}\n");
  const auto x = column_of(all, 0), y = column_of(all, 3);
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    xy += (x[i] - 1) * (y[i] - 12.5), xx += (x[i] - 1) * (x[i] - 1), yy += (y[i] - 12.5) * (y[i] - 12.5);
  }
  EXPECT_LT(std::abs(xy) / std::sqrt(xx * yy), 0.29) << "four standard deviations, 1 / sqrt(199) each";
  EXPECT_FALSE(std::is_sorted(x.begin(), x.end()));
}

TEST(Sampling, AHypercubeIsTheSameOfTheSameSeed) {
  const auto of_seed = [](const std::string& seed) {
    return values_in(sampled_of(spans + "sampling: {latin_hypercube: 9" + seed + "}\n"));
  };
  EXPECT_EQ(of_seed(", seed: 5"), of_seed(", seed: 5"));
  EXPECT_NE(of_seed(", seed: 5"), of_seed(", seed: 6"));
  EXPECT_EQ(of_seed(""), of_seed(", seed: 1"));
}

TEST(Sampling, EveryWholeNumberOfALogarithmicSpanCanBeTaken) {
  const auto all =
      sampled_of("axes: {body.seed: {from: 1, to: 8, log: true, whole: true}}\nsampling: {latin_hypercube: 2000}\n");
  std::vector<int> taken(9);
  for (const double value : column_of(all, 0)) {
    ASSERT_GE(value, 1);
    ASSERT_LE(value, 8);
    ASSERT_EQ(value, std::floor(value));
    ++taken[static_cast<std::size_t>(value)];
  }
  for (int value = 1; value <= 8; ++value) {  // its share of log(9): one case more or less at each end
    const double share = 2000 * std::log((value + 1.0) / value) / std::log(9.0);
    EXPECT_NEAR(taken[static_cast<std::size_t>(value)], share, 2) << value;
  }
}

TEST(Sampling, SamplesLieWithinTheirSpan) {
  const auto all = sampled_of(
      "axes: {time.end: {from: 1.00000049, to: 1.00000051}, body.seed: {from: 1234567, to: 1234570, whole: true}, "
      "grid.spacing: {from: 0.05, to: 0.1}}\nsampling: {latin_hypercube: 4}\n");
  for (const double value : column_of(all, 0)) {
    EXPECT_GE(value, 1.00000049);
    EXPECT_LE(value, 1.00000051);
  }
  auto seeds = column_of(all, 1);
  std::sort(seeds.begin(), seeds.end());
  EXPECT_EQ(seeds, (std::vector<double>{1234567, 1234568, 1234569, 1234570}));
  for (const Combination& one : all) {
    EXPECT_LE(one.values[2].value.size(), 9u)
        << "a sample is no more than six digits where these do: " << one.values[2].value;
    EXPECT_EQ(one.settings[2].path, "grid.spacing");
    EXPECT_EQ(one.settings[2].value.text, one.values[2].value);
    EXPECT_EQ(one.settings[2].value.where.line, 2);
  }
}

TEST(Sampling, ExclusionHoldsOnSamplesToo) {
  const auto all = sampled_of(spans + "sampling: {latin_hypercube: 20}\nexclude: [{time.end: {above: 1}}]\n");
  EXPECT_EQ(all.size(), 10u) << "each half is as often taken";
  for (const double value : column_of(all, 0)) EXPECT_LE(value, 1);
}

}  // namespace
}  // namespace assay::drivers::test_sampling
