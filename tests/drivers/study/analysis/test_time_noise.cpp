// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/clock.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_time_noise {
namespace {

/// A study of 10 cases, each run so often, whose times scatter by sigma; of some runs a disturbance takes a third more.
StudyFindings noisy_study(std::mt19937_64& random, int repeats, double sigma, double factor, double disturbed = 0) {
  std::normal_distribution<double> noise(0, sigma);
  std::bernoulli_distribution is_disturbed(disturbed);
  StudyFindings study;
  study.cost_key = "step_cpu_s", study.cost_unit = "s";
  for (int i = 0; i < 10; ++i) {
    StudyCase one = small_completed("m", 0.1 / (i + 1), 1e-3, 1);
    std::vector<double> seconds;
    for (int k = 0; k < repeats; ++k)
      seconds.push_back(factor * std::exp(noise(random)) * (is_disturbed(random) ? 1.33 : 1));
    set_clock(one, seconds);
    study.cases.push_back(one);
  }
  return study;
}

/// The share of cases that are told apart, of 400 pairs of studies.
double share_told_apart(int repeats, double sigma, double factor, double disturbed = 0) {
  std::mt19937_64 random(static_cast<std::uint64_t>(repeats));
  int told = 0, all = 0;
  for (int k = 0; k < 400; ++k) {
    const StudyFindings A = noisy_study(random, repeats, sigma, 1, disturbed);
    const StudyFindings B = noisy_study(random, repeats, sigma, factor, disturbed);
    const CostNoise noise(A, B);
    for (std::size_t i = 0; i < A.cases.size(); ++i, ++all) {
      const double bound = noise.between(A.cases[i], B.cases[i]).bound;
      if (told_apart(*A.cases[i].cost, *B.cases[i].cost, bound) != 0) ++told;
    }
  }
  return told / double(all);
}

// The rates that docs/studies.md states.
TEST(LongTimeNoise, NoiseAloneIsNotToldApart) {
  for (const int repeats : {3, 5, 10}) {
    for (const double sigma : {0.002, 0.02, 0.05, 0.1})
      EXPECT_LE(share_told_apart(repeats, sigma, 1), 1e-3) << repeats << " " << sigma;
  }
  EXPECT_LE(share_told_apart(2, 0.05, 1), 1e-2);
}

TEST(TimeNoise, DisturbedRunsAreRarelyToldApart) {
  EXPECT_LE(share_told_apart(3, 0.02, 1, 0.1), 0.02);
  EXPECT_LE(share_told_apart(5, 0.02, 1, 0.1), 0.01);
}

TEST(TimeNoise, AFifthMoreIsFound) {
  for (const int repeats : {3, 5}) {
    EXPECT_GE(share_told_apart(repeats, 0.01, 1.2), 0.99) << repeats;
    EXPECT_GE(share_told_apart(repeats, 0.02, 1.2), 0.95) << repeats;
    EXPECT_GE(share_told_apart(repeats, 0.02, 1 / 1.2), 0.95) << repeats;
  }
}

TEST(TimeNoise, BoundsSayWhatTheyRestOn) {
  StudyFindings study = two_method_study();
  const StudyCase &a = study.cases[0], &b = study.cases[1];
  EXPECT_EQ(CostNoise(study, study).between(a, b).bound, repeated_floor);
  EXPECT_TRUE(CostNoise(study, study).between(a, b).measured);
  set_clock(study.cases[1], {8, 10, 6});
  EXPECT_NEAR(CostNoise(study, study).between(a, b).bound, 3 * std::hypot(0.01, 0.25), 1e-12);
  set_clock(study.cases[1], {8});
  EXPECT_EQ(CostNoise(study, study).between(a, b).bound, single_floor);
  EXPECT_FALSE(CostNoise(study, study).between(a, b).measured);
  study.cost_key = "work.particle_steps", study.cost_unit = "";
  EXPECT_EQ(CostNoise(study, study).between(a, b).bound, counted_floor);
}

TEST(TimeNoise, OneQuietCaseBorrowsTheNoiseOfTheOthers) {
  StudyFindings study = two_method_study();
  for (StudyCase& one : study.cases) {
    if (one.cost) set_clock(one, {*one.cost, 1.2 * *one.cost, 0.8 * *one.cost});
  }
  set_clock(study.cases[0], {1, 1, 1});
  EXPECT_NEAR(CostNoise(study, study).between(study.cases[0], study.cases[0]).bound, 3 * std::hypot(0.2, 0.2), 1e-12);
}

TEST(TimeNoise, ToldApartIsRelativeToTheSmaller) {
  EXPECT_EQ(told_apart(1, 1.06, 0.05), 1);
  EXPECT_EQ(told_apart(1.06, 1, 0.05), -1);
  EXPECT_EQ(told_apart(1, 1.04, 0.05), 0);
  EXPECT_EQ(told_apart(0, 0, 0.05), 0);
  EXPECT_EQ(told_apart(0, 1, 0.05), 1);
  EXPECT_EQ(told_apart(1, std::numeric_limits<double>::quiet_NaN(), 0.05), 0);
}

}  // namespace
}  // namespace assay::drivers::test_time_noise
