// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/body_force.hpp"

#include "harness/motion/kinds/vortex.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_inertia_to_particles {
namespace {

constexpr Method updated{Basis::cpdi2, Transfer::aflip, Update::usl, Formulation::updated, Mass::lumped};
constexpr Method total{Basis::bspline2, Transfer::aflip, Update::usl, Formulation::total, Mass::lumped};
constexpr double spin = 3.1;  ///< [rad/s]

Method in_leapfrog(Method method) {
  method.integrator = Integrator::leapfrog;
  return method;
}

/// A free ring that only turns, seen so from a spinning frame.
Setup<2> turning(int across, const Method& method, Inertia inertia) {
  Setup<2> setup = vortex_setup(across, method);
  auto& vortex = *setup.motion->as<Vortex>();
  vortex.amplitude.peak = 0;
  setup.exact = exact_polar(vortex, setup.density,
                            std::make_shared<const Response>(*ClosedForm::of(setup.material, vortex.baseline())));
  setup.frame.emplace();
  setup.frame->spin = spin;
  setup.inertia = inertia;
  return setup;
}

/// Largest distance from where a rigid rotation takes the particles, after a quarter of a second [m].
double off_the_circle(const Setup<2>& setup, int steps) {
  constexpr double end = 0.25;
  Simulation<2> simulation(setup);
  const double dt = end / steps;
  for (int k = 0; k < steps; ++k) {
    EXPECT_FALSE(simulation.step(k * dt, dt)) << simulation.state().finding->reason;
  }
  const State<2>& s = simulation.state();
  const Tensor Q = rotation_about_z(spin * end);
  double worst = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vector3 X(s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p], 0);
    const Vector3 x(s.column(Column::position, 0)[p], s.column(Column::position, 1)[p], 0);
    worst = std::max(worst, (x - Q * X).norm());
  }
  return worst;
}

// The motion of a particle under its own a, whatever the grid: the error is that of the time step, of its order.
TEST(InertiaPass, TurnsABodyExactlyButForTheTimeStep) {
  for (const Method& method : {in_leapfrog(updated), in_leapfrog(total)}) {
    const double coarse = off_the_circle(turning(3, method, Inertia::particles), 100);
    const double fine = off_the_circle(turning(5, method, Inertia::particles), 100);
    const double half_step = off_the_circle(turning(3, method, Inertia::particles), 200);
    EXPECT_NEAR(coarse / half_step, 4, 0.1) << name_of(method);
    EXPECT_NEAR(coarse / fine, 1, 0.02) << name_of(method);  // but for how far out the farthest particle is
  }
}

TEST(InertiaPass, ALumpedGridTurnsItWorse) {
  for (const Method& method : {in_leapfrog(updated), in_leapfrog(total)}) {
    EXPECT_GT(off_the_circle(turning(3, method, Inertia::grid), 100),
              20 * off_the_circle(turning(3, method, Inertia::particles), 100))
        << name_of(method);
  }
}

/// Of the vortex to T/4: gaps of the accounts, over the amounts.
struct InertiaGaps {
  double momentum = 0, angular = 0, energy = 0;
};
InertiaGaps inertia_gaps_of(const Method& method, int steps) {
  Setup<2> setup = vortex_setup(6, method);
  setup.inertia = Inertia::particles;
  setup.accounts = true;
  Simulation<2> simulation(setup);
  const State<2>& s = simulation.state();
  const auto before = momentum(s);
  const double spin_before = angular_momentum(s), energy_before = kinetic_energy(s);
  const double dt = 0.25 / steps;
  for (int k = 0; k < steps; ++k) EXPECT_FALSE(simulation.step(k * dt, dt));
  const auto after = momentum(s);
  const Ledger& ledger = s.ledger;
  const double gained = kinetic_energy(s) - energy_before;
  return {std::hypot(after[0] - before[0] - ledger.impulse[0], after[1] - before[1] - ledger.impulse[1]) /
              momentum_scale(s),
          std::abs(angular_momentum(s) - spin_before - ledger.angular_impulse[2]) / spin_before,
          std::abs(gained - ledger.external_work + ledger.internal_work) / energy_before};
}

TEST(InertiaPass, IsInTheAccounts) {
  constexpr double rounding = 1e-12;
  const Method flip{Basis::cpdi2, Transfer::flip, Update::usl};
  const InertiaGaps coarse = inertia_gaps_of(flip, 200), fine = inertia_gaps_of(flip, 400);
  EXPECT_LT(coarse.momentum, rounding);
  // kept up to the distance of nodes from their particles' centre of mass, of what the grid still carries
  EXPECT_LT(coarse.angular, 4e-3);
  EXPECT_NEAR(coarse.energy / fine.energy, 2, 0.2);  // closes with the time step
  EXPECT_LT(fine.energy, 0.02);
}

TEST(InertiaPass, HelpsALumpedMassInTheVortex) {
  const auto error = [](Inertia inertia) {
    mpm::Setup<2> setup = averaged_setup(10, false, total);
    setup.inertia = inertia;
    Simulation<2> simulation(setup);
    constexpr int steps = 200;
    for (int k = 0; k < steps; ++k) EXPECT_FALSE(simulation.step(k * 0.5 / steps, 0.5 / steps));
    return displacement_error(simulation.state(), 0.5);
  };
  EXPECT_LT(error(Inertia::particles), 0.6 * error(Inertia::grid));
}

TEST(InertiaPass, IsThereOnlyWhereItIsAskedFor) {
  const auto has_pass = [](Inertia inertia) {
    mpm::Setup<2> setup = vortex_setup(4);
    setup.inertia = inertia;
    for (const auto& pass : compose(setup)) {
      if (pass.name == "inertia_to_particles") return true;
    }
    return false;
  };
  EXPECT_FALSE(has_pass(Inertia::grid));
  EXPECT_TRUE(has_pass(Inertia::particles));
}

}  // namespace
}  // namespace assay::mpm::test_inertia_to_particles
