// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/sheet.hpp"
#include "tests/harness/disguised_material.hpp"

namespace assay::test_course {
namespace {

constexpr double end = 1;
const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.02, 1.0}}.baseline();
constexpr double yield_stress = 5;

std::shared_ptr<const Material> plain() {
  return builtin_material(assay_builtin_j2_jaumann,
                          {{"E", 1000}, {"nu", 0.3}, {"yield_stress", yield_stress}, {"kinematic_modulus", 50}});
}

/// Times at which a history's regime changes, and what it took to find them.
struct Found {
  std::vector<double> times;
  std::int64_t calls;
};
Found found(const Material& material, double xi) {
  const Course course(material, path, end);
  History history(course, xi, {.tolerance = 1e-11, .watch = true});
  history.advance(end);
  Found result{{}, history.calls()};
  for (const Branch& branch : history.branches()) result.times.push_back(branch.begin);
  return result;
}

class Disguised : public testing::TestWithParam<Disguise> {};

TEST_P(Disguised, TellsWhereItYieldsAndAsksForLittleMore) {
  const double known_to = 1e-11 + GetParam().tolerance, more = 1.3;
  const auto material = disguised_j2(GetParam(), yield_stress);
  for (const double xi : {-3.5, -0.5, 0.2, 1.3}) {
    const Found expected = found(*plain(), xi), seen = found(*material, xi);
    ASSERT_GE(expected.times.size(), 3u);
    ASSERT_EQ(seen.times.size(), expected.times.size()) << xi;
    for (std::size_t k = 0; k < seen.times.size(); ++k) EXPECT_NEAR(seen.times[k], expected.times[k], known_to) << xi;
    EXPECT_LT(static_cast<double>(seen.calls), more * static_cast<double>(expected.calls)) << xi;
  }
}

TEST_P(Disguised, HasASheetOfNoMoreCalls) {
  constexpr double tolerance = 1e-6, more = 1.3;
  const auto material = disguised_j2(GetParam(), yield_stress);
  const Sheet expected(*plain(), path, {.tolerance = tolerance, .end = end}),
      seen(*material, path, {.tolerance = tolerance, .end = end});
  EXPECT_LT(seen.error_tau(), tolerance);
  EXPECT_TRUE(seen.has_kinks());
  EXPECT_LT(static_cast<double>(seen.material_calls()), more * static_cast<double>(expected.material_calls()));
  for (const double xi : {-3.1, -0.3, 0.9}) {
    for (const double t : {0.15, 0.4, 0.66, 0.95}) {
      Tensor tau, slope, exact, exact_slope;
      seen.at(xi, t, tau, slope);
      expected.at(xi, t, exact, exact_slope);
      EXPECT_LT((tau - exact).cwiseAbs().maxCoeff(), 2 * tolerance * expected.error().tau_scale) << xi << " " << t;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Disguised,
                         testing::Values(Disguise{.clock = true, .counts = true}, Disguise{.clock = true}, Disguise{},
                                         Disguise{.counts = true, .tolerance = 1e-6}, Disguise{.tolerance = 1e-6}),
                         [](const auto& instance) {
                           return std::string(instance.param.counts ? "counts" : "back_stress_alone") +
                                  (instance.param.clock ? "_with_a_clock" : "") +
                                  (instance.param.tolerance > 0 ? "_within_a_tolerance" : "");
                         });

/// The shear by which the stress of von Mises grows by the tolerance's share of the yield stress; found by halving.
TEST(Course, FindsTheShortestIncrementThatTells) {
  constexpr double shear_modulus = 1000 / 2.6, by_halving = 2, of_states = 1.2;
  for (const double tolerance : {1e-8, 1e-6, 1e-4}) {
    const double shear = tolerance * yield_stress / (std::sqrt(3.0) * shear_modulus);
    const ShortestTelling found =
        march_coarsely(*disguised_j2({.counts = true, .tolerance = tolerance}, yield_stress), path, end).shortest;
    EXPECT_GT(found.norm, shear / of_states) << tolerance;
    EXPECT_LT(found.norm, shear * by_halving * of_states) << tolerance;
    EXPECT_NEAR(found.stress, found.norm * shear_modulus, 0.01 * found.stress) << tolerance;
  }
  EXPECT_EQ(march_coarsely(*disguised_j2({.counts = true}, yield_stress), path, end).shortest.norm, 0);
}

/// A state that a long step leaves within the yield surface, as an explicit update does, is no tolerance.
TEST(Course, DoesNotTakeTheErrorOfALongStepForATolerance) {
  static const assay_material table = [] {
    assay_material t = *assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0);
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0)
          ->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      for (std::size_t p = 0; p < n; ++p) {
        double squares = 0;
        for (std::size_t c = 0; c < 9; ++c) squares += std::pow(step->F1[c * n + p] - step->F0[c * n + p], 2);
        if (state1[p] == state0[p]) continue;
        for (std::size_t c = 1; c < 7; ++c) state1[c * n + p] *= 1 - squares;
      }
    };
    return t;
  }();
  const Material material(&table,
                          {{"E", 1000}, {"nu", 0.3}, {"yield_stress", yield_stress}, {"kinematic_modulus", 50}});
  EXPECT_LT(march_coarsely(material, path, end).shortest.norm, 1e-10);
}

TEST(Course, SeesWhatChangesInEveryStep) {
  const auto material = disguised_j2({.clock = true, .counts = true}, yield_stress);
  const CoarseMarch seen = march_coarsely(*material, path, end);  // stress, back stress, plastic strain, clock
  EXPECT_TRUE(seen.signs.any_start);
  EXPECT_EQ(seen.signs.always, (std::vector<char>{1, 0, 0, 1}));
  EXPECT_EQ(seen.signs.changes, (std::vector<char>{1, 1, 1, 1}));
  EXPECT_GT(seen.largest[1], 2);
}

}  // namespace
}  // namespace assay::test_course
