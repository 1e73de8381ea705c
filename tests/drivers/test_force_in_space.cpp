// SPDX-License-Identifier: BSD-3-Clause
// What is left out of the body force in space does not pass: its component along z, and that along the axis of the
// vortex, which a model has whose tau33 is not zero.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/error_sampler.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/simulation.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_force_in_space {
namespace {

using mpm::Column;

/// Behind the pass of the body force: its part along the unit vector `left_out`, none where that is zero, is taken
/// away.
void plant(std::vector<mpm::Pass<3>>& passes, const Vector3& left_out) {
  const auto force = std::ranges::find(passes, "body_force", &mpm::Pass<3>::name);
  ASSERT_NE(force, passes.end());
  mpm::Pass<3> planted;
  planted.name = "planted";
  planted.slot = {mpm::Phase::body_force, mpm::Part::last};
  planted.stages = force->stages;
  planted.bind = [left_out](mpm::State<3>& s) -> mpm::Kernel {
    return [&s, left_out](const mpm::Instant&) {
      for (std::size_t p = 0; p < s.particles; ++p) {
        double along = 0;
        for (int d = 0; d < 3; ++d) along += left_out(d) * s.column(Column::body_force, d)[p];
        for (int d = 0; d < 3; ++d) s.column(Column::body_force, d)[p] -= along * left_out(d);
      }
    };
  };
  passes.insert(force + 1, planted);
}

/// A scene of configs/space, and what it expects.
struct Ball {
  explicit Ball(const std::string& name)
      : problem(
            assemble<3>(read_scene(tree_folder() + "/configs/space/" + name + ".yaml", {"output.accounts=false"}), 1)) {
    exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
    problem.setup.exact = exact;
    axis = problem.scene.motion.as<Vortex3d>()->one.axis.normalized();
  }

  /// Largest L2 of the displacement over time [m].
  double largest_error(const Vector3& left_out) const {
    std::vector<mpm::Pass<3>> passes = mpm::compose(problem.setup);
    plant(passes, left_out);
    mpm::Simulation<3> simulation(problem.setup, passes);
    ErrorSampler<3> sampler(problem, exact, simulation.state());
    double largest = 0;
    for (std::int64_t k = 0; k < problem.steps; ++k) {
      const double t = problem.time_of_step(k), next = problem.time_of_step(k + 1);
      if (simulation.step(t, next - t)) return INFINITY;
      if (k % 4 != 0) continue;  // a sample takes as long as a few steps
      largest = std::max(largest, sampler.sample(simulation.state(), next, simulation.velocity_time()).displacement.l2);
    }
    return largest;
  }

  /// What the scene expects it to be below [m].
  double bound() const {
    const auto& lines = problem.scene.expect;
    const auto line = std::ranges::find(lines, "error.l2_max", &Expectation::key);
    return line == lines.end() ? NAN : line->number;
  }

  ProblemIn<3> problem;
  ExactSolutionPtr exact;
  Vector3 axis;
};

TEST(LongForceInSpace, WithoutItsPartAlongTheAxisOrAlongZItFailsTheBallOfMooneyRivlin) {
  const Ball ball("ball_mooney_rivlin");
  EXPECT_LT(ball.largest_error(Vector3::Zero()), ball.bound());
  EXPECT_GT(ball.largest_error(ball.axis), ball.bound());
  EXPECT_GT(ball.largest_error(Vector3::UnitZ()), ball.bound());
}

// tau33 is zero, and b has no part along the axis that could be missed.
TEST(LongForceInSpace, OfNeoHookeanHasNoPartAlongTheAxis) {
  const Ball ball("ball_bspline2");
  const double right = ball.largest_error(Vector3::Zero());
  EXPECT_LT(right, ball.bound());
  EXPECT_NEAR(ball.largest_error(ball.axis), right, 1e-6 * right);
  EXPECT_GT(ball.largest_error(Vector3::UnitZ()), ball.bound());
}

}  // namespace
}  // namespace assay::drivers::test_force_in_space
