// SPDX-License-Identifier: BSD-3-Clause
// Bodies that are left to themselves: where they begin, and what they keep.
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_free_body {
namespace {

const std::string moment_scene = "hard/free_vibration_moment";

std::string free_body(const std::string& more = "force: {response: none}\n", const std::string& outside = "") {
  return "motion: {type: vortex, amplitude: {peak: 0.1}}\n"
         "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
         "body: {domain: square, " +
         outside +
         "initial_velocity: {velocity: [0.3, -0.2], spin: 0.5, stretching: [0.1, -0.4, 0.2]}}\n"
         "grid: {spacing: 0.25}\nmethod: {transfer: apic}\n" +
         more;
}

std::string refused(const std::string& text) {
  return refusal_of([&] { scene_from_text(text, "f.yaml"); });
}

TEST(FreeBody, BeginsAsItIsTold) {
  const Problem problem = assemble(scene_from_text(free_body("force: {response: none}\n", "outside: free, "), "f"), 1);
  const mpm::Simulation<2> simulation(problem.setup);
  const mpm::State<2>& s = simulation.state();
  using mpm::Column;
  ASSERT_GT(s.particles, 0U);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double x = s.column(Column::position, 0)[p], y = s.column(Column::position, 1)[p];
    EXPECT_NEAR(s.column(Column::velocity, 0)[p], 0.3 + 0.1 * x + (0.2 - 0.5) * y, 1e-15);
    EXPECT_NEAR(s.column(Column::velocity, 1)[p], -0.2 + (0.2 + 0.5) * x - 0.4 * y, 1e-15);
    EXPECT_EQ(s.column(Column::affine, 1)[p], 0.2 - 0.5);
    EXPECT_EQ(s.column(Column::affine, 2)[p], 0.2 + 0.5);
  }
}

TEST(FreeBody, IsRefusedWhereItIsNotFree) {
  EXPECT_EQ(refused(free_body("force: {response: none}\n", "outside: free, ")), "accepted");
  EXPECT_NE(refused(free_body("", "outside: free, ")).find("the body force drives this body: set force.response: none"),
            std::string::npos);
  EXPECT_NE(refused(free_body()).find("body.outside: held"), std::string::npos);
  EXPECT_NE(refused(free_body("force: {response: none}\nframe: {angle: 1}\n", "outside: free, ")).find("frame"),
            std::string::npos);
}

// What apic carries as a moment loses no angular momentum, and the account sees the loss of what carries a gradient.
TEST(FreeBody, KeepsItsAngularMomentumWithMomentsAndNotWithGradients) {
  const auto drift = [](const std::string& affine) {
    const auto result = result_of_run(moment_scene, {"time.end=2", "grid.spacing=0.0625", "method.affine=" + affine});
    return result["drift"]["angular_momentum"].get<double>();
  };
  constexpr double rounding = 1e-13;
  EXPECT_LT(drift("moment"), rounding);
  EXPECT_GT(drift("gradient"), 1e4 * rounding);
}

}  // namespace
}  // namespace assay::drivers::test_free_body
