// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mpm/patch/patch.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::mpm::test_bench {
namespace {

constexpr Method cpdi{Basis::cpdi, Transfer::flip, Update::usl};

TEST(PatchBench, HasASquareOfOneMetreWithTwoByTwoParticlesACell) {
  const Bench<2> bench = bench_of<2>(elastic_material(), true);
  // (lambda + 2 mu) / rho at E = 1000, nu = 0.3, rho = 1000
  EXPECT_NEAR(bench.wave_speed, std::sqrt(0.7 / (1.3 * 0.4)), 1e-6);
  const mpm::Setup<2> setup = patch_setup(cpdi, bench, 8);
  EXPECT_EQ(setup.seeds.size(), 256u);
  EXPECT_EQ(setup.grid.spacing, 0.125);
  EXPECT_EQ(setup.grid.first[0], -12);
  EXPECT_NEAR(setup.seeds.volume() * 256, 1, 1e-15);
}

/// How far the particles are from F X: smallest and largest of both directions [m].
std::array<double, 2> moved(Arrangement arrangement, const Mat<2>& F) {
  Simulation<2> simulation(patch_setup(cpdi, bench_of<2>(elastic_material(), true), 8));
  State<2>& s = simulation.state();
  arrange(s, arrangement);
  std::array<double, 2> range{HUGE_VAL, -HUGE_VAL};
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < 2; ++d) {
      const auto& X = s.setup.seeds.X;
      const double far =
          s.column(Column::position, static_cast<int>(d))[p] - F[2 * d] * X[0][p] - F[2 * d + 1] * X[1][p];
      range = {std::min(range[0], far), std::max(range[1], far)};
    }
    for (int c = 0; c < 4; ++c) {
      EXPECT_EQ(s.column(Column::deformation_gradient, c)[p], F[static_cast<std::size_t>(c)]);
    }
  }
  return range;
}

TEST(PatchBench, ArrangementsAreWhatTheySay) {
  const Mat<2> identity{1, 0, 0, 1}, F = homogeneous_deformation<2>();
  const double h = 0.125, distance = h / 2;
  EXPECT_EQ(moved(Arrangement::seeded, identity), (std::array<double, 2>{0, 0}));
  const auto shifted = moved(Arrangement::shifted, identity), deformed = moved(Arrangement::deformed, F),
             jittered = moved(Arrangement::jittered, F);
  EXPECT_NEAR(shifted[0], -std::log10(std::exp(1.0)) * h, 1e-15);
  EXPECT_NEAR(shifted[1], h / std::acos(-1.0), 1e-15);
  EXPECT_LT(deformed[1] - deformed[0], 1e-15);
  EXPECT_LT(jittered[0], -0.29 * distance);
  EXPECT_GT(jittered[1], 0.29 * distance);
  EXPECT_LE(jittered[1] - jittered[0], 0.6 * distance);
}

TEST(PatchBench, GradedSeedsFillTheSquareWithUnequalRectangles) {
  const Seeds<2> seeds = graded_seeds<2>(8);
  ASSERT_EQ(seeds.size(), 256u);
  double volume = 0, smallest = 1, largest = 0, moment = 0;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    volume += seeds.volume(p);
    moment += seeds.volume(p) * seeds.X[0][p];
    smallest = std::min(smallest, seeds.half_edges[p][0]);
    largest = std::max(largest, seeds.half_edges[p][3]);
  }
  EXPECT_NEAR(volume, 1, 1e-14);
  EXPECT_NEAR(moment, 0, 1e-14);
  EXPECT_GT(smallest, 0.4 * seeds.half_size[0]);
  EXPECT_LT(smallest, 0.8 * seeds.half_size[0]);
  EXPECT_GT(largest, 1.2 * seeds.half_size[1]);
}

TEST(PatchBench, PassesAreInsertedBehindAndInPlaceOfThoseOfAPhase) {
  std::vector<Pass<2>> passes(3);
  passes[0].name = passes[2].name = "a";
  passes[1].name = "b";
  passes[0].slot = passes[2].slot = {Phase::grid};
  passes[1].slot = {Phase::forces};
  Pass<2> probe, other;
  probe.name = "probe";
  other.name = "other";
  insert_after(passes, {Phase::grid, Phase::stress}, probe);
  replace(passes, Phase::forces, other);
  std::string names;
  for (const auto& pass : passes) names += pass.name + " ";
  EXPECT_EQ(names, "a probe other a probe ");
  EXPECT_THROW(insert_after(passes, {Phase::forces}, probe), std::logic_error);
  EXPECT_THROW(replace(passes, Phase::forces, probe), std::logic_error);
}

TEST(PatchBench, JudgesWhatIsPromisedAndTellsTheRest) {
  const auto pass = judged(cpdi, "translation", {1e-16, "fine"}, 1e-12, "broken");
  EXPECT_EQ(pass.verdict, check::Verdict::pass);
  EXPECT_EQ(pass.threshold, 1e-12);
  const auto fail = judged(cpdi, "translation", {1e-3, "bad", 1.0}, 1e-12, "broken");
  EXPECT_EQ(fail.verdict, check::Verdict::fail);
  EXPECT_EQ(fail.cause, "broken");
  EXPECT_EQ(fail.order, 1.0);
  const auto none = judged(cpdi, "translation", {std::nan(""), "bad"}, 1e-12, "broken");
  EXPECT_EQ(none.verdict, check::Verdict::fail);
  EXPECT_FALSE(none.measure);
  const auto told = judged(cpdi, "stress.jittered", {0.4, "large"}, 1e-12, "broken");
  EXPECT_EQ(told.verdict, check::Verdict::not_applicable);
  EXPECT_EQ(told.measure, 0.4);
  EXPECT_FALSE(told.threshold);
  EXPECT_EQ(told.sentence, "large; not promised: " + exemption(cpdi, "stress.jittered"));
}

TEST(PatchBench, MomentumIsThatOfTheParticles) {
  const mpm::Setup<2> setup = patch_setup(cpdi, bench_of<2>(elastic_material(), true), 8);
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    s.column(Column::velocity, 0)[p] = 2 - s.column(Column::position, 1)[p];
    s.column(Column::velocity, 1)[p] = s.column(Column::position, 0)[p];
  }
  const Momentum<2> found = momentum_of(s);
  EXPECT_NEAR(found.linear[0], 2000, 1e-9);
  EXPECT_NEAR(found.linear[1], 0, 1e-9);
  EXPECT_NEAR(found.angular[2], 1000.0 / 6, 1);  // rho a^4 / 6, at points
}

}  // namespace
}  // namespace assay::mpm::test_bench
