// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/symplectic_stages.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
// clang-format off: Odeint's stepper does not include its base
#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
// clang-format on

namespace assay::test_symplectic_stages {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// x'' = -sin x + cos t / 2.
double force(double x, double t) { return -std::sin(x) + 0.5 * std::cos(t); }

struct Point {
  double x = 1, v = 0.3;
};

Point advance(Point p, double end, int steps, bool driven) {
  const double dt = end / steps;
  for (int k = 0; k < steps; ++k) {
    for (const SymplecticStage& stage : symplectic_rkn4()) {
      p.v += stage.kick * dt * force(p.x, driven ? (k + stage.begin) * dt : std::acos(0.0));
      p.x += stage.drift * dt * p.v;
    }
  }
  return p;
}

TEST(SymplecticStages, FillAStepAndReadTheSameBackwards) {
  const auto stages = symplectic_rkn4();
  ASSERT_EQ(stages.size(), 5u);
  double drift = 0, kick = 0;
  for (std::size_t k = 0; k < stages.size(); ++k) {
    EXPECT_NEAR(stages[k].begin, drift, epsilon);
    drift += stages[k].drift;
    kick += stages[k].kick;
    EXPECT_EQ(stages[k].drift, stages[stages.size() - 1 - k].drift);
    if (k > 0) {
      EXPECT_EQ(stages[k].kick, stages[stages.size() - k].kick);
    }
  }
  EXPECT_NEAR(drift, 1, 4 * epsilon);
  EXPECT_NEAR(kick, 1, 4 * epsilon);
  EXPECT_EQ(stages[0].kick, 0);
}

TEST(SymplecticStages, AreThoseOfOdeint) {
  using State = std::vector<double>;
  boost::numeric::odeint::symplectic_rkn_sb3a_m4_mclachlan<State> stepper;
  const auto pull = [](const State& x, State& a) { a[0] = force(x[0], std::acos(0.0)); };
  State x{1}, v{0.3};
  for (int k = 0; k < 10; ++k) stepper.do_step(pull, x, v, 0.0, 0.1);
  const Point found = advance({}, 1, 10, false);
  EXPECT_NEAR(found.x, x[0], 20 * epsilon);
  EXPECT_NEAR(found.v, v[0], 20 * epsilon);
}

// Of a force that depends on time, too, which Odeint's own step does not take.
TEST(SymplecticStages, AreOfFourthOrder) {
  const Point exact = advance({}, 2, 2000, true);
  const auto error = [&](int steps) {
    const Point p = advance({}, 2, steps, true);
    return std::hypot(p.x - exact.x, p.v - exact.v);
  };
  EXPECT_GT(std::log2(error(20) / error(40)), 3.8);
  EXPECT_GT(std::log2(error(40) / error(80)), 3.8);
}

}  // namespace
}  // namespace assay::test_symplectic_stages
