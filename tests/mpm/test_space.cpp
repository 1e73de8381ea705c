// SPDX-License-Identifier: BSD-3-Clause
// Particles in space.
#include <gtest/gtest.h>

#include "harness/motion/kinds/homogeneous.hpp"
#include "tests/mpm/space_setup.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_space {
namespace {

Method total_spline() {
  Method method;
  method.basis = Basis::bspline2, method.formulation = Formulation::total, method.transfer = Transfer::aflip;
  method.mass = Mass::series, method.terms = 4;
  return method;
}

Method corners() {
  Method method;
  method.basis = Basis::cpdi2, method.transfer = Transfer::aflip, method.mass = Mass::series;
  return method;
}

constexpr double sound = 1.17, fastest = 3.2;  ///< of the ball's material and motion, rounded up [m/s]

int steps_for(const mpm::Setup<3>& setup) {
  return static_cast<int>(std::ceil(0.5 * (sound + fastest) / setup.grid.spacing / 0.4));
}

/// Until T/2, where the body is farthest.
double error_at_half(const mpm::Setup<3>& setup) {
  Simulation<3> simulation(setup);
  const int steps = steps_for(setup);
  const double dt = 0.5 / steps;
  for (int k = 0; k < steps; ++k) {
    if (simulation.step(k * dt, dt)) return INFINITY;
  }
  return displacement_error(simulation.state(), 0.5);
}

TEST(Space, ABallConvergesWithTheGrid) {
  const double coarse = error_at_half(ball_setup(4, total_spline())),
               fine = error_at_half(ball_setup(8, total_spline()));
  EXPECT_LT(coarse, 1.2e-2);
  EXPECT_LT(fine, 1.2e-3);
  EXPECT_LT(error_at_half(ball_setup(8, corners())), 2e-3);
}

TEST(Space, WithoutItsForceAlongTheAxisTheBallGoesElsewhere) {
  mpm::Setup<3> setup = ball_setup(8, total_spline());
  auto passes = compose(setup);
  Pass<3> planted;
  planted.name = "planted";
  planted.slot = {Phase::body_force, Part::last};
  planted.writes = {Column::body_force};
  planted.bind = [](State<3>& s) -> Kernel {
    return [&s](const Instant&) { std::fill_n(s.column(Column::body_force, 2), s.particles, 0.0); };
  };
  passes.insert(passes.begin() + 1, planted);
  Simulation<3> simulation(setup, passes);
  const int steps = steps_for(setup);
  for (int k = 0; k < steps && !simulation.state().finding; ++k) simulation.step(k * 0.5 / steps, 0.5 / steps);
  EXPECT_GT(displacement_error(simulation.state(), 0.5), 5e-3);  // the right one errs by a fifth of it
}

TEST(Space, AFreeBallKeepsItsMomentumAndAllOfItsMoment) {
  Method method;
  method.basis = Basis::cpdi, method.transfer = Transfer::apic, method.affine = Affine::moment;
  mpm::Setup<3> setup = ball_setup(4, method);
  setup.body_force = false;  // whose moment is booked where the particles have moved to
  setup.accounts = true;
  Simulation<3> simulation(setup);
  State<3>& s = simulation.state();
  const Vec<3> before = momentum(s);
  constexpr double dt = 0.01;
  for (int k = 0; k < 20; ++k) ASSERT_FALSE(simulation.step(k * dt, dt));
  const Vec<3> after = momentum(s);
  for (std::size_t d = 0; d < 3; ++d)
    EXPECT_LT(std::abs(after[d] - before[d] - s.ledger.impulse[d]), 1e-12 * momentum_scale(s));
  ASSERT_TRUE(s.ledger.grid_angular);
  EXPECT_LT(s.ledger.grid_angular_defect, 1e-12 * s.ledger.grid_angular_scale);
}

TEST(Space, TheMomentOfTheForceIsBookedAboutAllThreeAxes) {
  mpm::Setup<3> setup = ball_setup(4, total_spline());
  setup.accounts = true;
  Simulation<3> simulation(setup);
  const State<3>& s = simulation.state();
  Vector3 given = Vector3::Zero();
  constexpr double dt = 0.01;
  for (int k = 0; k < 20; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt));
    for (std::size_t p = 0; p < s.particles; ++p)
      given += dt * s.column(Column::mass)[p] *
               at_particle(s, Column::position, p).cross(at_particle(s, Column::body_force, p));
  }
  ASSERT_GT(given.cwiseAbs().minCoeff(), 1);
  EXPECT_LT((given - Vector3(s.ledger.angular_impulse.data())).norm(), 1e-12 * given.norm());
}

// In a layer of cells with the next one on each side nothing of the third dimension is left.
TEST(LongSpace, ALayerIsPlaneStrain) {
  for (const bool total : {true, false}) {
    Method method = total ? total_spline() : corners();
    const mpm::Setup<2> plane = vortex_setup(8, method);
    mpm::Setup<3> layer;
    const double h = plane.grid.spacing;
    const auto& motion = *plane.motion->as<Vortex>();
    const std::array<double, 3> lower{-motion.outer, -motion.outer, 0}, upper{motion.outer, motion.outer, h};
    layer.method = method;
    layer.grid = grid_around(lower, upper, h, 4);
    layer.seeds = cartesian_lattice(lower, upper, h, {2, 2, 2}, [&](const auto& X) {
      return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::absent;
    });
    layer.ends[2] = {0.0, h, true};
    layer.density = plane.density, layer.material = plane.material, layer.motion = plane.motion;
    layer.body_force = true, layer.exact = plane.exact;
    Simulation<2> flat(plane);
    Simulation<3> deep(layer);
    const State<2>& a = flat.state();
    const State<3>& b = deep.state();
    ASSERT_EQ(b.particles, 2 * a.particles);
    constexpr double dt = 2e-3;
    for (int k = 0; k < 60; ++k) {
      ASSERT_FALSE(flat.step(k * dt, dt));
      ASSERT_FALSE(deep.step(k * dt, dt));
    }
    std::map<std::pair<double, double>, std::size_t> of_plane;
    for (std::size_t p = 0; p < a.particles; ++p)
      of_plane[{a.column(Column::reference_position, 0)[p], a.column(Column::reference_position, 1)[p]}] = p;
    double apart = 0, moved = 0;
    for (std::size_t p = 0; p < b.particles; ++p) {
      const std::size_t q =
          of_plane.at({b.column(Column::reference_position, 0)[p], b.column(Column::reference_position, 1)[p]});
      for (int d = 0; d < 2; ++d) {
        apart = std::max(apart, std::abs(b.column(Column::position, d)[p] - a.column(Column::position, d)[q]));
        moved =
            std::max(moved, std::abs(a.column(Column::position, d)[q] - a.column(Column::reference_position, d)[q]));
      }
      apart = std::max(apart, std::abs(b.column(Column::position, 2)[p] - b.column(Column::reference_position, 2)[p]));
    }
    EXPECT_GT(moved, 0.1);
    EXPECT_LT(apart, 1e-12) << (total ? "total" : "updated");
  }
}

/// A cube of 2^3 to 4^3 cells that is stretched and sheared, under tractions on all faces.
double error_of_loaded_cube(const Method& method, int across, TractionForm form) {
  Homogeneous motion;
  motion.final << 1.3, 0.2, -0.1, 0.05, 1.1, 0.15, 0.1, -0.2, 1.2;
  mpm::Setup<3> setup;
  const std::array<double, 3> lower{0, 0, 0}, upper{1, 1, 1};
  const double h = 1.0 / across;
  setup.method = method;
  setup.grid = grid_around(lower, upper, h, 2 * across);
  setup.seeds = cartesian_lattice(lower, upper, h, {2, 2, 2}, [](const auto&) { return Fate::stepped; });
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    Cuboid domain;
    for (std::size_t d = 0; d < 3; ++d) {
      domain.lower[d] = setup.seeds.X[d][p] - setup.seeds.half_size[d];
      domain.upper[d] = setup.seeds.X[d][p] + setup.seeds.half_size[d];
    }
    add_surface_edges<3>({lower, upper}, {}, domain, static_cast<std::uint32_t>(p), setup.seeds.surface);
  }
  EXPECT_EQ(setup.seeds.surface.size(), static_cast<std::size_t>(24 * across * across));
  setup.density = 1000;
  setup.material = elastic_material(1e6, 0.3);
  setup.motion = motion;
  setup.traction = Traction{TractionAlgorithm::edges, form};
  setup.exact = exact_uniform(motion, setup.density, setup.material, motion.baseline(), 1, 1e-13);
  Simulation<3> simulation(setup);
  const int steps = 250 * across;
  for (int k = 0; k < steps; ++k) {
    if (simulation.step(static_cast<double>(k) / steps, 1.0 / steps)) return INFINITY;
  }
  return displacement_error(simulation.state(), 1);
}

TEST(LongSpace, TractionsOnAllFacesOfACubeHoldToRounding) {
  Method method;
  method.basis = Basis::cpdi2, method.transfer = Transfer::apic;
  for (const int across : {2, 4}) EXPECT_LT(error_of_loaded_cube(method, across, TractionForm::reference), 1e-12);
  method.basis = Basis::cpdi;
  EXPECT_LT(error_of_loaded_cube(method, 2, TractionForm::reference), 1e-12);
}

}  // namespace
}  // namespace assay::mpm::test_space
