// SPDX-License-Identifier: BSD-3-Clause
// A yield test with a tolerance, and times to which increments are shorter than that.
#include <gtest/gtest.h>

#include "harness/history/history.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/band.hpp"
#include "tests/harness/disguised_material.hpp"

namespace assay::test_history_near_times {
namespace {

constexpr double end = 1, yield_stress = 5;
constexpr int times = 30;
const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.02, 1.0}}.baseline();

struct NearTimes {
  const char* name;
  std::size_t at;   ///< which break
  double distance;  ///< of the times from it and from each other [s]
};

class NearTimesOf : public testing::TestWithParam<NearTimes> {};

/// Beyond the first plastic increment, which begins at the edge of the tolerance, both materials are on one surface.
TEST_P(NearTimesOf, LieOnTheSurfaceAsTheyDoWithoutTheTolerance) {
  constexpr double xi = 1.3, tolerance = 1e-6, known_to = 3e-10;  // [Pa]; an elastic increment errs by 1e-6 * 5 Pa
  constexpr double error_stated = 1e-8;  // a step over a front that no time marks has some of it
  const auto tolerant = disguised_j2({.counts = true, .tolerance = tolerance}, yield_stress),
             exact = disguised_j2({.counts = true}, yield_stress);
  const Course course(*tolerant, path, end, Form::increments), other(*exact, path, end, Form::increments);
  std::int64_t calls = 0;
  const Ray ray = trace(course, xi, {.tolerance = 1e-12, .watch = true}, calls);
  const NearTimes& near = GetParam();
  std::vector<double> at;
  for (int k = 0; k <= times; ++k) {
    at.push_back(ray.breaks[near.at] + (near.distance > 0 ? k : k - times) * std::abs(near.distance));
  }
  const HistoryTrail seen = follow(course, xi, {.tolerance = 1e-12}, at),
                     expected = follow(other, xi, {.tolerance = 1e-12}, at);
  for (std::size_t k = 1; k < at.size(); ++k) {
    EXPECT_LT((seen.cauchy(k) - expected.cauchy(k)).cwiseAbs().maxCoeff(), known_to) << k;
  }
  EXPECT_LT(seen.error, error_stated);
}

INSTANTIATE_TEST_SUITE_P(Places, NearTimesOf,
                         testing::Values(NearTimes{"behind_a_front", 1, 1e-9}, NearTimes{"farther_behind", 1, 3e-7},
                                         NearTimes{"before_a_reversal", 2, -1e-8},
                                         NearTimes{"farther_before", 2, -3e-5},
                                         NearTimes{"behind_a_reversal", 2, 3e-6}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace assay::test_history_near_times
