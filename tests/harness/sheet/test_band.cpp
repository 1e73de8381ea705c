// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/band.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/band_series.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_band {
namespace {

const std::map<std::string, double> plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", 20}};

TEST(BandMap, GoesThereAndBackWithItsSlope) {
  for (const bool lower : {false, true}) {
    for (const bool upper : {false, true}) {
      const BandMap map{{-1.5, 0.25}, lower, upper};
      EXPECT_DOUBLE_EQ(map.xi_of(0), -1.5);
      EXPECT_DOUBLE_EQ(map.xi_of(1), 0.25);
      for (const double s : {0.01, 0.3, 0.5, 0.77, 0.99}) {
        EXPECT_NEAR(map.s_of(map.xi_of(s)), s, 1e-12);
        EXPECT_NEAR(map.slope(s), (map.xi_of(s + 1e-6) - map.xi_of(s - 1e-6)) / 2e-6, 1e-8);
      }
      EXPECT_EQ(map.slope(0) == 0, lower);
      EXPECT_EQ(map.slope(1) == 0, upper);
      EXPECT_NEAR(map.s_of(-9), 0, 1e-15);
      EXPECT_NEAR(map.s_of(9), 1, 1e-15);
    }
  }
}

TEST(Bands, AreDividedWhereYieldingBeginsToExist) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, path, 0.5, Form::increments);  // loading alone
  std::int64_t calls = 0;
  const std::vector<Band> bands = find_bands(course, {.tolerance = 1e-12, .watch = true}, {}, {}, calls);
  ASSERT_EQ(bands.size(), 4u);
  const double mu = 1000 / 2.6, gamma_y = 2 * std::asin(10 / (std::sqrt(3.0) * 2 * mu));
  EXPECT_NEAR(bands[0].map.xi.upper, -gamma_y / 0.2, 1e-10);
  EXPECT_EQ(bands[1].map.xi.upper, 0);
  EXPECT_NEAR(bands[2].map.xi.upper, gamma_y / 0.2, 1e-10);
  EXPECT_EQ(bands[1].stretches(), 1u);
  EXPECT_EQ(bands[3].stretches(), 2u);
  EXPECT_TRUE(bands[3].map.grazes_lower && !bands[3].map.grazes_upper);
  EXPECT_EQ(bands.front().map.xi.lower, path.parameter.lower);
  EXPECT_EQ(bands.back().map.xi.upper, path.parameter.upper);
}

/// There are 49 samples and 48 gaps, each with a look at the caller; what is between is looked for by many histories.
TEST(Bands, CanBeStoppedBetweenTheHistoriesOfAGap) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, path, 0.5, Form::increments);
  std::int64_t calls = 0;
  int polls = 0;
  const HistoryOptions options{.tolerance = 1e-8, .watch = true};
  find_bands(course, options, {}, {1, [&] { ++polls; }}, calls);
  EXPECT_GT(polls, 110);
  struct Stop {};
  const int most = polls - 1;
  polls = 0;
  const auto stop = [&] {
    if (++polls == most) throw Stop{};
  };
  EXPECT_THROW(find_bands(course, options, {}, {1, stop}, calls), Stop);
}

TEST(Bands, AreFoundAtTheVeryEndsOfTheRange) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  for (const double share : {0.97, 0.997, 0.9999}) {
    const double mu = 1000 / 2.6, gamma_y = 0.2 * share * std::abs(path.parameter.lower);
    const double yield = std::sqrt(3.0) * 2 * mu * std::sin(gamma_y / 2);
    const auto material = builtin_material(
        assay_builtin_j2_jaumann, {{"E", 1000}, {"nu", 0.3}, {"yield_stress", yield}, {"hardening_modulus", 10}});
    const Course course(*material, path, 0.5, Form::increments);
    std::int64_t calls = 0;
    const std::vector<Band> bands = find_bands(course, {.tolerance = 1e-12, .watch = true}, {}, {}, calls);
    EXPECT_NEAR(bands.front().map.xi.upper, share * path.parameter.lower, 1e-8) << share;
    EXPECT_EQ(bands.front().stretches(), 2u) << share;
  }
}

/// After one cycle the stress comes back to the yield surface at the very peak of the next, over a whole range of xi:
/// rounding must not make bands of it.
TEST(Bands, AreNotMadeByReloadingToTheSamePeak) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::one_minus_cosine, 0.1, 1.0}}.baseline();
  for (const auto& entry : {assay_builtin_j2_jaumann, assay_builtin_j2_multiplicative}) {
    const auto material =
        builtin_material(entry, {{"E", 1000}, {"nu", 0.3}, {"yield_stress", 140}, {"hardening_modulus", 200}});
    std::size_t bands[2] = {};
    for (const int cycles : {1, 2}) {
      const Course course(*material, path, cycles, Form::increments);
      std::int64_t calls = 0;
      bands[cycles - 1] = find_bands(course, {.tolerance = 1e-12, .watch = true}, {}, {}, calls).size();
    }
    EXPECT_LE(bands[1], bands[0] + 2) << material->name();
  }
}

TEST(BandSeries, FollowsTheFrontAndSurvivesPacking) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const Course course(*material, path, 0.5, Form::increments);
  const HistoryOptions options{.tolerance = 1e-12, .watch = true};
  std::int64_t calls = 0;
  const Band band = find_bands(course, options, {}, {}, calls).back();
  const BandSeries table(course, band, {30, 30}, options, {});
  const double gamma_y = 2 * std::asin(10 / (std::sqrt(3.0) * 2 * 1000 / 2.6));
  for (const double xi : {0.3, 1.1, 2.5}) {  // |gamma| = gamma_y there
    const double front = std::asin(gamma_y / (2 * xi * 0.1)) / std::acos(-1.0);
    EXPECT_NEAR(table.break_at(1, band.map.s_of(xi)), front, 1e-9);
  }
  std::vector<double> packed;
  table.pack(packed);
  std::span<const double> left(packed);
  const BandSeries copy(left);
  EXPECT_TRUE(left.empty());
  Tensor tau, slope, again, slope_again;
  table.at(0.7, 0.31, tau, slope);
  copy.at(0.7, 0.31, again, slope_again);
  EXPECT_EQ(tau, again);
  EXPECT_EQ(slope, slope_again);
  // negative control: without its breaks the same number of nodes does not resolve the kink
  const Course plain(*material, path, 0.5, Form::increments);
  const Band whole{{{0, path.parameter.upper}}, {plain.pieces, {1}}, 1};
  const BandSeries blind(plain, whole, {30, 30}, {.tolerance = 1e-12, .watch = false}, {});
  EXPECT_LT(std::max(table.tail_in_xi(), table.tail_in_t()), 1e-6 * table.largest());
  EXPECT_GT(std::max(blind.tail_in_xi(), blind.tail_in_t()), 1e-4 * blind.largest());
}

}  // namespace
}  // namespace assay::test_band
