// SPDX-License-Identifier: BSD-3-Clause
// Runs in space of motions that a spinning, flying frame sees. Where the particles are given the inertia, the error is
// that of the time step alone: Coriolis' and the centrifugal force are there, also where the motion itself has no
// force.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/quiet_run.hpp"

namespace assay::drivers::test_frames_in_space {
namespace {

constexpr double near_order = 0.1;      ///< of the order 2 in the time step
constexpr double of_the_motion = 1e-3;  ///< a missing force errs by a tenth of it and more

double relative_error(const std::string& scene, std::vector<std::string> sets, const std::string& step) {
  for (const char* set : {"frame={spin: 2, axis: [1, 2, 0], velocity: [0.3, 0.2, 0.1]}", "force.inertia=particles",
                          "method={basis: cpdi2, transfer: apic, integrator: leapfrog}", "material.parameters.E=1e3",
                          "output={errors: 20, particles: 0, pictures: false, report: false}", "grid.spacing=0.25"}) {
    sets.emplace_back(set);
  }
  sets.push_back("time={end: 1, step: " + step + "}");
  return result_of_run(scene, sets)["error"]["relative"].get<double>();
}

class FramesInSpace : public testing::TestWithParam<std::pair<std::string, std::vector<std::string>>> {};

TEST_P(FramesInSpace, ErrByTheTimeStepAlone) {
  const auto& [scene, sets] = GetParam();
  const double coarse = relative_error(scene, sets, "0.01"), fine = relative_error(scene, sets, "0.005");
  EXPECT_LT(coarse, of_the_motion);
  EXPECT_NEAR(std::log2(coarse / fine), 2, near_order) << coarse << ", " << fine;
}

INSTANTIATE_TEST_SUITE_P(Motions, FramesInSpace,
                         testing::Values(std::pair("space/homogeneous", std::vector<std::string>{}),
                                         std::pair("space/rotating_stretch", std::vector<std::string>{}),
                                         std::pair("space/homogeneous",
                                                   std::vector<std::string>{
                                                       "motion={type: rigid, velocity: [1, 0.3, 0.2]}",
                                                       "body.lower=[-0.25, -0.25, -0.25]",
                                                       "body.upper=[0.25, 0.25, 0.25]"})));

}  // namespace
}  // namespace assay::drivers::test_frames_in_space
