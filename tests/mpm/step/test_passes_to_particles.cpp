// SPDX-License-Identifier: BSD-3-Clause
// Whole steps: conservation of momentum and mass, rigid translation.
#include "mpm/step/passes.hpp"

#include <limits>
#include <numeric>

#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_passes_to_particles {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct TransferPasses : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, TransferPasses, testing::ValuesIn(all_methods()), way_name);
struct TransferPassesInSpace : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, TransferPassesInSpace, testing::ValuesIn(methods_that_are(true)), way_name);
struct LongTransferPassesInSpace : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, LongTransferPassesInSpace, testing::ValuesIn(methods_that_are(false)), way_name);

/// Of the grid's inertia field: mass, then momentum.
template <int Dim>
std::array<double, Dim + 1> sum_of_nodes(const State<Dim>& s) {
  std::array<double, Dim + 1> sum{};
  for (std::size_t i = 0; i < s.inertia.nodes(); ++i) {
    for (std::size_t c = 0; c <= Dim; ++c) sum[c] += s.inertia.node(i)[c];
  }
  return sum;
}

template <int Dim>
double mass(const State<Dim>& s) {
  return std::accumulate(s.column(Column::mass), s.column(Column::mass) + s.particles, 0.0);
}

// Without body force the ring spins up stresses of its own: they must not push the whole.
TEST_P(TransferPasses, KeepsMomentumAndMassInTheVortex) {
  mpm::Setup<2> setup = vortex_setup(5, GetParam());
  setup.body_force = false;
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {  // a drift besides, so that the sum is not zero by symmetry
    s.column(Column::velocity, 0)[p] += 0.7;
    s.column(Column::velocity, 1)[p] -= 0.3 * s.column(Column::position, 0)[p];
  }
  const auto before = momentum(s);
  double scale = momentum_scale(s), stress = 0;
  const double dt = 1e-3;
  for (int k = 0; k < 50; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
    scale = std::max(scale, momentum_scale(s));
    const auto grid = sum_of_nodes(s);
    EXPECT_NEAR(grid[0], mass(s), 1e3 * epsilon * mass(s));
  }
  const auto after = momentum(s);
  for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(after[d], before[d], 50 * 100 * epsilon * scale);
  for (std::size_t p = 0; p < s.particles; ++p) stress = std::max(stress, std::abs(s.column(Column::stress, 1)[p]));
  EXPECT_GT(stress, 10);  // [Pa]: there was something to conserve against
}

template <int Dim>
void expect_rigid_translation(const Method& way) {
  const std::array<double, 3> all{0.61803398875, -0.41421356237, 0.27182818285};
  Simulation<Dim> simulation(block_setup<Dim>(way));
  State<Dim>& s = simulation.state();
  for (int d = 0; d < Dim; ++d) {
    std::fill_n(s.column(Column::velocity, d), s.particles, all[static_cast<std::size_t>(d)]);
  }
  const double dt = 1e-2;
  const int steps = 110;  // through 6.8, 4.6 and 3 cells
  for (int k = 0; k < steps; ++k) ASSERT_FALSE(simulation.step(k * dt, dt)) << k << ": " << s.finding->reason;
  // each step rounds x, v and F; stresses of that size push back
  const double bound = steps * 20 * epsilon;
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int d = 0; d < Dim; ++d) {
      const double v = all[static_cast<std::size_t>(d)];
      EXPECT_NEAR(s.column(Column::position, d)[p], s.column(Column::reference_position, d)[p] + steps * dt * v, bound);
      EXPECT_NEAR(s.column(Column::velocity, d)[p], v, bound);
      for (int e = 0; e < Dim; ++e) {
        EXPECT_NEAR(s.column(Column::deformation_gradient, d * Dim + e)[p], d == e ? 1 : 0, 10 * bound);
      }
    }
  }
}

TEST_P(TransferPasses, TranslatesRigidlyThroughManyCells) { expect_rigid_translation<2>(GetParam()); }
TEST_P(TransferPassesInSpace, TranslatesRigidlyThroughManyCells) { expect_rigid_translation<3>(GetParam()); }
TEST_P(LongTransferPassesInSpace, TranslatesRigidlyThroughManyCells) { expect_rigid_translation<3>(GetParam()); }

// Random velocities and stresses in three dimensions.
void expect_momentum_kept_in_space(const Method& method) {
  Simulation<3> simulation(block_setup<3>(method));
  State<3>& s = simulation.state();
  Random random(7);
  for (int d = 0; d < 3; ++d) {
    for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity, d)[p] = 0.2 * random() + 0.1;
  }
  const auto before = momentum(s);
  const double scale = momentum_scale(s), dt = 1e-3;
  for (int k = 0; k < 50; ++k) ASSERT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
  const auto after = momentum(s);
  for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(after[d], before[d], 50 * 100 * epsilon * scale);
}

TEST_P(TransferPassesInSpace, KeepsMomentum) { expect_momentum_kept_in_space(GetParam()); }
TEST_P(LongTransferPassesInSpace, KeepsMomentum) { expect_momentum_kept_in_space(GetParam()); }

TEST_P(TransferPasses, FindsAParticleThatLeavesTheGrid) {
  Simulation<2> simulation(block_setup<2>(GetParam()));
  State<2>& s = simulation.state();
  constexpr std::size_t runaway = 11;
  if (s.has(Column::corners)) {
    for (int c = 0; c < 4; ++c)
      s.column(Column::corners, 2 * c + 1)[runaway] += 1.02 - s.column(Column::position, 1)[runaway];
  }
  s.column(Column::position, 1)[runaway] = 1.02;
  if (GetParam().is_total()) s.column(Column::reference_position, 1)[runaway] = 1.02;  // where its weights are
  ASSERT_TRUE(simulation.step(0, 1e-3));
  EXPECT_EQ(s.finding->kind, Finding::Kind::unstable);
  EXPECT_EQ(s.finding->particle, static_cast<std::int64_t>(runaway));
  EXPECT_NE(s.finding->reason.find("left the grid"), std::string::npos);
}

TEST_P(TransferPasses, FindsAVelocityThatIsNotFinite) {
  Simulation<2> simulation(block_setup<2>(GetParam()));
  State<2>& s = simulation.state();
  s.column(Column::velocity, 0)[5] = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3 && !s.finding; ++k) simulation.step(k * 1e-3, 1e-3);
  ASSERT_TRUE(s.finding);
  EXPECT_EQ(s.finding->kind, Finding::Kind::unstable);
}

}  // namespace
}  // namespace assay::mpm::test_passes_to_particles
