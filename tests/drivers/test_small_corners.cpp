// SPDX-License-Identifier: BSD-3-Clause
// Runs where parts meet that rarely do.
#include <gtest/gtest.h>

#include "tests/drivers/quiet_run.hpp"

namespace assay::drivers::test_small_corners {
namespace {

TEST(SmallCorners, AGridOfFewNodesHoldsEveryBasis) {
  for (const char* basis : {"linear", "ugimp", "cpgimp", "cpdi", "cpdi2", "bspline2", "bspline3", "bspline4"}) {
    const auto result =
        result_of_run("hard/flight_1000",
                      {"body={domain: square, lower: [0, 0], upper: [1, 1], initial_velocity: {velocity: [0, 0]}}",
                       "grid={spacing: 1, lower: [0, 0], upper: [1, 1]}", std::string("method={basis: ") + basis + "}",
                       "time.end=1"});
    EXPECT_EQ(result["outcome"], "completed") << basis;
  }
}

TEST(SmallCorners, AveragedVolumesReachAModelInAProcessOfItsOwn) {
  const auto error = [](const char* isolation) {
    return result_of_run("hard/nu_49", {"grid.spacing=0.125", "time.end=0.05", "remedies.anti_locking=cell",
                                        std::string("material.isolation=") + isolation})["error"]["l2_max"];
  };
  EXPECT_EQ(error("worker"), error("none"));
}

/// Of nodes that only the surface's forces reach: they are cleared, too, where the stress comes first.
TEST(SmallCorners, TractionsLeaveNoForcesBehind) {
  for (const char* update : {"usf", "musl"}) {
    const auto result = result_of_run(
        "hard/near_inverted_20",
        {"motion.final=[[1, 0, 0], [0, 0.5, 0], [0, 0, 1]]", "material.parameters.E=1e3", "grid.spacing=0.0625",
         "expect={}", std::string("method={basis: linear, transfer: fmpm, update: ") + update + "}"});
    EXPECT_LT(result["drift"]["momentum"].get<double>(), 1e-12) << update;
  }
}

}  // namespace
}  // namespace assay::drivers::test_small_corners
