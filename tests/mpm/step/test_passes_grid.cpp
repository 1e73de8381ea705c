// SPDX-License-Identifier: BSD-3-Clause
// Nodes and particles that are held.
#include "mpm/step/passes.hpp"

#include <limits>
#include <numeric>

#include "harness/motion/kinds/vortex.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_passes_grid {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The square around the ring with everything outside of it held; `right_half`: only what lies at x > 0, so that no
/// sum vanishes by symmetry.
Setup<2> square_setup(const Method& way, bool right_half) {
  Setup<2> setup = vortex_setup(5, way);
  const Vortex motion;
  const std::array<double, 2> lower{right_half ? 0.0 : -1.5, -1.5}, upper{1.5, 1.5};
  setup.grid = grid_around(lower, upper, setup.grid.spacing, 4);
  setup.seeds = cartesian_lattice(lower, upper, setup.grid.spacing, {2, 2}, [&](const auto& X) {
    return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::held;
  });
  setup.hold_outside = setup.accounts = true;
  return setup;
}

struct HeldOutside : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, HeldOutside, testing::ValuesIn(all_methods()), way_name);

double particle_mass(const State<2>& s) {
  return std::accumulate(s.column(Column::mass), s.column(Column::mass) + s.particles, 0.0);
}

TEST_P(HeldOutside, NodesOutsideTheRingStayAndTheirMassCounts) {
  Simulation<2> simulation(square_setup(GetParam(), false));
  State<2>& s = simulation.state();
  const double held = s.setup.density * s.setup.seeds.volume() * static_cast<double>(s.setup.seeds.held.size());
  EXPECT_NEAR(particle_mass(s) + held, 1000 * 9, 1e-9 * 9000);  // the whole square, 1000 kg/m^2
  const double dt = 1e-3;
  for (int k = 0; k < 20; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
    double mass = 0;
    for (std::size_t i = 0; i < s.inertia.nodes(); ++i) mass += s.inertia.node(i)[0];
    EXPECT_NEAR(mass, particle_mass(s) + held, 1e3 * epsilon * mass);
    std::size_t outside = 0;
    for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
      const auto count = static_cast<std::size_t>(s.setup.grid.count[0]);
      const double x = s.setup.grid.coordinate(0, static_cast<std::int32_t>(i % count));
      const double y = s.setup.grid.coordinate(1, static_cast<std::int32_t>(i / count));
      if (std::hypot(x, y) > 0.75 && std::hypot(x, y) < 1.25) continue;
      ++outside;
      for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(s.motion.node(i)[c], 0);
    }
    EXPECT_EQ(outside, s.own<Held>().nodes.size());
  }
  EXPECT_LT(s.ledger.mass_defect, 1e3 * epsilon);
  EXPECT_GT(momentum_scale(s), 1);  // the ring turns inside
}

// What the particles lost beside the body force's impulse, the holding took: also where nothing cancels by symmetry.
TEST_P(HeldOutside, ReactionsBalanceTheMomentum) {
  Simulation<2> simulation(square_setup(GetParam(), true));
  State<2>& s = simulation.state();
  const auto before = momentum(s);
  const double dt = 1e-3;
  double scale = momentum_scale(s);
  for (int k = 0; k < 50; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
    scale = std::max(scale, momentum_scale(s));
  }
  const auto after = momentum(s);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_NEAR(after[d] - before[d], s.ledger.impulse[d], 50 * 100 * epsilon * scale);
  }
}

TEST(GridPasses, EmptyNodesStandStill) {
  mpm::Setup<2> setup = block_setup<2>({});
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  std::fill_n(s.column(Column::velocity, 0), s.particles, 1.0);
  ASSERT_FALSE(simulation.step(0, 1e-3));
  for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
    EXPECT_NEAR(s.motion.node(i)[0], s.inertia.node(i)[0] > 0 ? 1 : 0, 100 * epsilon);
    EXPECT_EQ(s.motion.node(i)[1], 0);
  }
}

}  // namespace
}  // namespace assay::mpm::test_passes_grid
