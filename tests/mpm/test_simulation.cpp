// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/simulation.hpp"

#include <cstring>

#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_simulation {
namespace {

constexpr double dt = 1e-3;

void run(Simulation<2>& simulation, int steps) {
  for (int k = 0; k < steps; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt)) << simulation.state().finding->reason;
  }
}

/// Every column of a, byte for byte as in b.
void expect_same_bytes(const State<2>& a, const State<2>& b) {
  ASSERT_EQ(a.particles, b.particles);
  for (std::size_t k = 0; k < column_count; ++k) {
    ASSERT_EQ(a.columns[k].bytes(), b.columns[k].bytes());
    if (a.columns[k].empty()) continue;
    EXPECT_EQ(std::memcmp(a.columns[k].component(0), b.columns[k].component(0), a.columns[k].bytes()), 0)
        << info(static_cast<Column>(k)).name;
  }
  EXPECT_EQ(a.ledger.impulse, b.ledger.impulse);
  EXPECT_EQ(a.ledger.angular_impulse, b.ledger.angular_impulse);
  EXPECT_EQ(a.ledger.internal_work, b.ledger.internal_work);
  EXPECT_EQ(a.ledger.external_work, b.ledger.external_work);
  EXPECT_EQ(a.ledger.mass_defect, b.ledger.mass_defect);
}

struct EveryMethod : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, EveryMethod, testing::ValuesIn(all_methods()), way_name);

TEST_P(EveryMethod, TwoRunsAndAnyNumberOfThreadsGiveTheSameBytes) {
  mpm::Setup<2> setup = vortex_setup(5, GetParam());
  setup.accounts = true;
  Simulation<2> first(setup), second(setup);
  setup.threads = 2;
  Simulation<2> threaded(setup);
  for (Simulation<2>* simulation : {&first, &second, &threaded}) run(*simulation, 30);
  expect_same_bytes(first.state(), second.state());
  expect_same_bytes(first.state(), threaded.state());
  EXPECT_NE(first.state().column(Column::position)[0], first.state().column(Column::reference_position)[0]);
}

TEST(Simulation, StartsFromTheExactStateOfTheMotion) {
  const Simulation<2> simulation(vortex_setup(5));
  const State<2>& s = simulation.state();
  EXPECT_EQ(displacement_error(s, 0), 0);
  double fastest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double X = s.column(Column::position, 0)[p], Y = s.column(Column::position, 1)[p];
    // g'(0) h(R) E_z x X with g'(0) = pi, h of section 2.4
    const double q = 8 * (std::hypot(X, Y) - 1) * (std::hypot(X, Y) - 1);
    const double omega = std::acos(-1.0) * (1 - 4 * q + 4 * q * q);
    EXPECT_NEAR(s.column(Column::velocity, 0)[p], -omega * Y, 1e-13);
    EXPECT_NEAR(s.column(Column::velocity, 1)[p], omega * X, 1e-13);
    fastest = std::max(fastest, omega);
    for (int c = 0; c < 4; ++c) EXPECT_EQ(s.column(Column::deformation_gradient, c)[p], c % 3 == 0 ? 1 : 0);
    EXPECT_EQ(s.column(Column::mass)[p], 1000 * s.column(Column::volume)[p]);
  }
  EXPECT_GT(fastest, 3);
}

TEST(Simulation, ParticlesOfUnequalVolumeStartFromTheExactStateWithTheRingsMass) {
  for (const bool polar : {false, true}) {
    Simulation<2> simulation(averaged_setup(5, polar));
    const State<2>& s = simulation.state();
    EXPECT_EQ(displacement_error(s, 0), 0);
    double mass = 0;
    for (std::size_t p = 0; p < s.particles; ++p) {
      mass += s.column(Column::mass)[p];
      EXPECT_EQ(s.column(Column::volume)[p], s.setup.seeds.volume(p));
    }
    EXPECT_NEAR(mass, 1000 * std::acos(-1.0) * (1.25 * 1.25 - 0.75 * 0.75), 1e-9);
    run(simulation, 20);
    double scale = 0;  // the force on the whole ring is zero by symmetry
    for (std::size_t p = 0; p < s.particles; ++p) {
      scale += s.column(Column::mass)[p] * std::abs(s.column(Column::body_force, 0)[p]);
    }
    double force = 0;
    for (std::size_t p = 0; p < s.particles; ++p)
      force += s.column(Column::mass)[p] * s.column(Column::body_force, 0)[p];
    EXPECT_LT(std::abs(force), 1e-12 * scale);
    EXPECT_GT(scale, 0);
  }
}

// b of a step on the lattice is the same whether its cells are told or found from the particles.
TEST(Simulation, TheAveragedForceOfALatticeIsThatOfItsCells) {
  mpm::Setup<2> setup = vortex_setup(5);
  setup.evaluation = Evaluation::domain_average;
  Simulation<2> found(setup);
  std::vector<Rectangle> cells;
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    Rectangle cell;
    for (std::size_t d = 0; d < 2; ++d) {
      cell.lower[d] = setup.seeds.X[d][p] - setup.seeds.half_size[d];
      cell.upper[d] = setup.seeds.X[d][p] + setup.seeds.half_size[d];
    }
    cells.push_back(cell);
  }
  setup.seeds.domains = std::make_shared<const ReferenceDomains>(domains_of(cells, {0.75, 1.25}, false));
  Simulation<2> told(setup);
  run(found, 3);
  run(told, 3);
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    for (int d = 0; d < 2; ++d) {
      const double b = found.state().column(Column::body_force, d)[p];
      EXPECT_NEAR(b, told.state().column(Column::body_force, d)[p], 1e-9 * (1 + std::abs(b)));
    }
  }
}

// With weights that differ, too, what the particles gain is what the body force gave.
TEST(Simulation, ParticlesAtGaussPointsOrMovedAtRandomFollowTheVortexAndKeepMomentum) {
  for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
    Method method{Basis::bspline2};
    method.formulation = formulation;
    Simulation<2> regular(vortex_setup(5, method));
    run(regular, 100);
    for (const bool gauss : {true, false}) {
      mpm::Setup<2> setup = square_setup(5, gauss, method);
      setup.accounts = true;
      Simulation<2> simulation(setup);
      const State<2>& s = simulation.state();
      const Vec<2> before = momentum(s);
      run(simulation, 100);
      const double scale = momentum_scale(s);
      for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_NEAR(momentum(s)[d] - before[d], s.ledger.impulse[d], 1e-12 * scale);
      }
      EXPECT_LT(displacement_error(s, 0.1), 1.5 * displacement_error(regular.state(), 0.1)) << gauss;
    }
  }
}

/// Against the frame's own formula, which knows nothing of the turns by which b is made: positions after a while, and
/// velocities at the start.
TEST(Simulation, FollowsTheMotionThatAFrameSees) {
  const Frame frame{0.7, 1.3, {0.4, -0.2, 0}};
  for (const bool averaged : {false, true}) {
    mpm::Setup<2> own = averaged ? averaged_setup(5, false) : vortex_setup(5), seen = own;
    turn(seen.seeds, frame.angle, true);
    seen.frame = frame;
    Simulation<2> resting(own), moving(seen);
    const State<2>& s = moving.state();
    const auto exact = [&](std::size_t p, double t) {
      const Vector3 X(s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p], 0);
      return frame.seen((*seen.motion)->at(frame.body_point(X), t), t);
    };
    const auto vector = [&](Column column, std::size_t p) {
      return Vector3(s.column(column, 0)[p], s.column(column, 1)[p], 0);
    };
    for (std::size_t p = 0; p < s.particles; ++p) {
      EXPECT_LT((vector(Column::velocity, p) - exact(p, 0).v).norm(), 1e-14);
    }
    run(resting, 200);
    run(moving, 200);
    double sum = 0;
    for (std::size_t p = 0; p < s.particles; ++p) sum += (vector(Column::position, p) - exact(p, 0.2).x).squaredNorm();
    EXPECT_LT(std::sqrt(sum / static_cast<double>(s.particles)), 1.3 * displacement_error(resting.state(), 0.2));
  }
}

TEST(Simulation, WithoutAMotionStartsAndStaysAtRest) {
  Simulation<2> simulation(block_setup<2>({}));
  run(simulation, 10);
  const State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    EXPECT_EQ(s.column(Column::position, 0)[p], s.column(Column::reference_position, 0)[p]);
    EXPECT_EQ(s.column(Column::velocity, 1)[p], 0);
  }
}

TEST(Simulation, AFindingStopsTheStepAtThePassThatFoundIt) {
  mpm::Setup<2> setup = vortex_setup(5);
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  s.column(Column::position, 0)[3] = 1e6;
  ASSERT_TRUE(simulation.step(0, dt));
  EXPECT_EQ(s.material_calls, 0);
  EXPECT_EQ(s.column(Column::position, 0)[4], s.column(Column::reference_position, 0)[4]);
}

TEST(Simulation, MaterialCallsAreParticleSteps) {
  Simulation<2> simulation(vortex_setup(4));
  run(simulation, 3);
  EXPECT_EQ(simulation.state().material_calls, 3 * static_cast<std::int64_t>(simulation.state().particles));
}

// The finding of the paper (figure 2): what CPDI carries through kills uGIMP before T/2.
TEST(Simulation, UgimpDiesWhereCpdiLives) {
  const auto death = [](Basis basis) {
    constexpr int across = 10;
    constexpr double step = 1.0 / (200 * across);
    Simulation<2> simulation(vortex_setup(across, {basis, Transfer::flip, Update::usl}));
    for (int k = 0; k < 100 * across; ++k) {
      if (simulation.step(k * step, step)) return (k + 1) * step;
    }
    return HUGE_VAL;
  };
  const double t = death(Basis::ugimp);
  EXPECT_GT(t, 0.28);
  EXPECT_LT(t, 0.45);
  EXPECT_EQ(death(Basis::cpdi), HUGE_VAL);
}

}  // namespace
}  // namespace assay::mpm::test_simulation
