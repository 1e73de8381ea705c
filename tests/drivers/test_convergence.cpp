// SPDX-License-Identifier: BSD-3-Clause
// The averaged body force in whole runs: CPDI, FLIP, three grids.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_convergence {
namespace {

/// error.l2_max of a moderate vortex that starts from rest, at h = .1, .05, .025 [m].
std::array<double, 3> errors(const char* body, const char* evaluation) {
  std::array<double, 3> found{};
  const char* spacings[] = {"grid.spacing=0.1", "grid.spacing=0.05", "grid.spacing=0.025"};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto result = result_of_run("paper/vortex_cpdi",
                                      {"motion.amplitude={type: one_minus_cosine, peak: 0.3}", "output={particles: 0}",
                                       "output.pictures=false", "output.report=false", body, evaluation, spacings[k]});
    found[k] = result["error"]["l2_max"].get<double>();
  }
  return found;
}

constexpr auto average = "force.evaluation=domain_average", point = "force.evaluation=point";

TEST(LongDomainAverage, ConvergesAtSecondOrderOnTheSquareAndBeatsPoints) {
  const char* square = "body={domain: square, outside: held}";
  const auto averaged = errors(square, average), at_points = errors(square, point);
  EXPECT_GT(averaged[0] / averaged[1], 3.5);
  EXPECT_GT(averaged[1] / averaged[2], 3.5);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(averaged[k], 0.9 * at_points[k]) << k;
}

TEST(LongDomainAverage, ConvergesAlikeOnTheClippedRingAndOnThePolarOne) {
  const auto clipped = errors("body={domain: ring, cut: clipped}", average);
  const auto polar = errors("body={domain: ring, lattice: polar}", average);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(clipped[k], polar[k], 0.05 * polar[k]) << k;
  EXPECT_GT(clipped[0] / clipped[1], 3);
  EXPECT_GT(clipped[1] / clipped[2], 2.3);
}

// Negative control: cells that reach out of the ring, averaged with zeros outside, carry the wrong force for their
// mass.
TEST(LongDomainAverage, DoesNotConvergeOnTheRingWithoutClipping) {
  const auto whole = errors("body={domain: ring, cut: whole}", average);
  EXPECT_LT(whole[1] / whole[2], 2);
  EXPECT_GT(whole[2], 0.02);
}

}  // namespace
}  // namespace assay::drivers::test_convergence
