// SPDX-License-Identifier: BSD-3-Clause
// The fourth-order symplectic step: what it is promised to do on a grid that stays as it is.
#include "mpm/step/stages.hpp"

#include <functional>
#include <limits>

#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_stages {
namespace {

constexpr double stage_epsilon = std::numeric_limits<double>::epsilon();

Method staged(Mass mass = Mass::lumped, Integrator integrator = Integrator::symplectic_rkn4) {
  Method method{Basis::bspline2};
  method.formulation = Formulation::total;
  method.mass = mass;
  method.integrator = integrator;
  return method;
}

constexpr Mass masses[] = {Mass::lumped, Mass::series, Mass::consistent};

void run(Simulation<2>& simulation, double end, int steps) {
  for (int k = 0; k < steps; ++k) {
    ASSERT_FALSE(simulation.step(end * k / steps, end / steps)) << simulation.state().finding->reason;
  }
}

/// A block of 4 x 4 particles set swinging by a velocity that strains it by about a tenth; no force acts on it.
std::unique_ptr<Simulation<2>> swinging(const Method& method) {
  auto simulation = std::make_unique<Simulation<2>>(block_setup<2>(method));
  State<2>& s = simulation->state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double X = s.column(Column::position, 0)[p] / 0.1, Y = s.column(Column::position, 1)[p] / 0.1;
    s.column(Column::velocity, 0)[p] = 0.05 * std::sin(1.5 * X) + 0.02 * Y * Y;
    s.column(Column::velocity, 1)[p] = -0.03 * std::sin(1.5 * Y) + 0.02 * X * Y;
  }
  return simulation;
}

/// Of the particles' motion and of the material [J].
double energy(const State<2>& s) {
  double sum = kinetic_energy(s);
  const auto* stored = s.setup.material->extension<assay_energy>(ASSAY_EXTENSION_ENERGY);
  for (std::size_t p = 0; p < s.particles; ++p) {
    double F[9] = {0, 0, 0, 0, 0, 0, 0, 0, 1}, density = 0;
    for (int c = 0; c < 4; ++c) F[3 * (c / 2) + c % 2] = s.column(Column::deformation_gradient, c)[p];
    stored->energy(s.setup.material->self(), 1, F, nullptr, &density);
    sum += s.column(Column::volume)[p] * density;
  }
  return sum;
}

double distance(const State<2>& a, const State<2>& b, Column column) {
  double sum = 0;
  for (std::size_t p = 0; p < a.particles; ++p) {
    for (int d = 0; d < 2; ++d) sum += std::pow(a.column(column, d)[p] - b.column(column, d)[p], 2);
  }
  return std::sqrt(sum / static_cast<double>(a.particles));
}

TEST(Stages, RunTransfersOnceAndForcesFourTimes) {
  mpm::Setup<2> setup = vortex_setup(4, staged());
  setup.accounts = true;
  std::map<std::string, std::size_t> times;
  for (const auto& pass : compose(setup)) times[pass.name] = times_a_step(pass, setup.method);
  EXPECT_EQ(times, (std::map<std::string, std::size_t>{{"body_force", 4},
                                                       {"weights", 1},
                                                       {"particles_to_grid", 1},
                                                       {"grid_forces", 4},
                                                       {"grid_update", 5},
                                                       {"grid_to_particles", 5},
                                                       {"accounts", 4},
                                                       {"stress", 5}}));
  Simulation<2> simulation(setup);
  run(simulation, 0.02, 2);
  EXPECT_EQ(simulation.state().material_calls, 2 * 5 * static_cast<std::int64_t>(setup.seeds.size()));
  EXPECT_EQ(simulation.velocity_time(), 0.02);
}

TEST(Stages, OfTheOtherIntegratorsAreOne) {
  for (const Method& method : all_methods()) {
    if (method.has_stages()) continue;
    const auto stages = stages_of(method);
    ASSERT_EQ(stages.size(), 1u);
    EXPECT_EQ(stages[0].begin, 0);
    EXPECT_EQ(stages[0].drift, 1);
    EXPECT_EQ(stages[0].kick, 1);
    for (const auto& pass : compose(vortex_setup(4, method))) EXPECT_EQ(times_a_step(pass, method), 1u);
  }
}

/// The vortex, whose force depends on time, to t = 0.12 on a coarse grid; far from the body's faces where the matrix is
/// consistent, which has row sums there.
constexpr double vortex_end = 0.12;

std::unique_ptr<Simulation<2>> vortex_after(const Method& method, int steps) {
  auto simulation = std::make_unique<Simulation<2>>(method.mass == Mass::consistent ? free_square_setup(4, method)
                                                                                    : vortex_setup(4, method));
  run(*simulation, vortex_end, steps);
  return simulation;
}

/// Of the positions' error in time, over one halving of the step.
double order(const Method& method, const State<2>& exact, int steps) {
  const double coarse = distance(vortex_after(method, steps)->state(), exact, Column::position);
  return std::log2(coarse / distance(vortex_after(method, 2 * steps)->state(), exact, Column::position));
}

// Against the same grid in steps so short that time errs by nothing. The controls show that the order is the
// integrator's: they go to the same limit, each in its own way.
TEST(LongStages, AreOfFourthOrderWhereLeapfrogIsOfSecondAndEulerOfFirst) {
  for (const Mass mass : masses) {
    const auto exact = vortex_after(staged(mass), 96);
    EXPECT_NEAR(order(staged(mass), exact->state(), 16), 4, 0.2);
    const double coarse = distance(vortex_after(staged(mass), 16)->state(), exact->state(), Column::velocity);
    const double fine = distance(vortex_after(staged(mass), 32)->state(), exact->state(), Column::velocity);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.2) << "velocities";
    if (mass != Mass::consistent) continue;
    EXPECT_NEAR(order(staged(mass, Integrator::leapfrog), exact->state(), 32), 2, 0.2);
    EXPECT_NEAR(order(staged(mass, Integrator::symplectic_euler), exact->state(), 32), 1, 0.2);
  }
}

// Many periods of a body of period 0.35 s: the error of the energy swings within bounds of fourth order.
TEST(LongStages, KeepTheEnergyOfABodyThatSwingsForLong) {
  constexpr double step = 0.01;
  constexpr int steps = 4000;
  for (const Mass mass : masses) {
    double largest[2][2] = {};
    for (const int halved : {0, 1}) {
      const auto simulation = swinging(staged(mass));
      const double first = energy(simulation->state()), dt = halved ? 0.5 * step : step;
      for (int k = 0; k < steps; ++k) {
        ASSERT_FALSE(simulation->step(k * dt, dt));
        double& most = largest[halved][2 * k / steps];
        most = std::max(most, std::abs(energy(simulation->state()) / first - 1));
      }
      EXPECT_LT(largest[halved][1], 1.5 * largest[halved][0]) << "grows";
    }
    EXPECT_GT(largest[0][0] / largest[1][0], 10) << largest[0][0] << " " << largest[1][0];
  }
}

// The account takes the forces' work over each kick, so that nothing but round-off is left.
TEST(Stages, CloseTheAccountOfEnergy) {
  for (const Mass mass : masses) {
    mpm::Setup<2> setup = vortex_setup(4, staged(mass));
    setup.accounts = true;
    Simulation<2> simulation(setup);
    const State<2>& s = simulation.state();
    const double first = kinetic_energy(s);
    run(simulation, 0.2, 20);
    // conjugate gradients end at a residual of 1e-12
    EXPECT_LT(std::abs(kinetic_energy(s) - first + s.ledger.internal_work - s.ledger.external_work), 1e-11 * first);
    EXPECT_GT(std::abs(kinetic_energy(s) / first - 1), 1e-2);
  }
}

TEST(Stages, ReadTheSameBackwardsInTime) {
  for (const Mass mass : masses) {
    const auto simulation = swinging(staged(mass)), start = swinging(staged(mass));
    State<2>& s = simulation->state();
    run(*simulation, 1, 60);
    EXPECT_GT(distance(s, start->state(), Column::position), 1e-3);
    for (int back = 0; back < 2; ++back) {
      for (int d = 0; d < 2; ++d) {
        for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity, d)[p] *= -1;
      }
      if (back == 0) run(*simulation, 1, 60);
    }
    // round-off of 600 stages, as conjugate gradients leave it
    EXPECT_LT(distance(s, start->state(), Column::position), 1e-12);
    EXPECT_LT(distance(s, start->state(), Column::velocity), 1e-11);
  }
}

TEST(Stages, AreRefusedWhereTheyWouldNotBeSymplectic) {
  const auto refused = [](const std::function<void(Method&)>& change) {
    Method method = staged();
    change(method);
    const auto found = contradiction(method);
    return found ? found->key : "accepted";
  };
  EXPECT_EQ(refused([](Method&) {}), "accepted");
  EXPECT_EQ(refused([](Method& m) { m.mass = Mass::consistent; }), "accepted");
  EXPECT_EQ(refused([](Method& m) { m.formulation = Formulation::updated; }), "method.integrator");
  EXPECT_EQ(refused([](Method& m) { m.transfer = Transfer::aflip; }), "method.transfer");
  EXPECT_EQ(refused([](Method& m) { m.transfer = Transfer::pic; }), "method.transfer");
  EXPECT_EQ(refused([](Method& m) { m.flip = 0.99; }), "method.flip");
  EXPECT_EQ(refused([](Method& m) { m.update = Update::musl; }), "method.update");
}

}  // namespace
}  // namespace assay::mpm::test_stages
