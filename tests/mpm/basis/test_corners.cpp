// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/basis/corners.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_corners {
namespace {

constexpr Method cpdi2{Basis::cpdi2, Transfer::flip, Update::usl};
constexpr double largest_shear_of_the_run = 0.3;  ///< at least: the test says nothing of a body that hardly moves
constexpr double kept = 1e-12;                    ///< round-off of a few hundred steps

Corners<2> corners_at(const State<2>& s, std::size_t p) {
  Corners<2> corners;
  for (int k = 0; k < corner_components<2>; ++k) {
    corners[static_cast<std::size_t>(k / 2)][static_cast<std::size_t>(k % 2)] = s.column(Column::corners, k)[p];
  }
  return corners;
}

std::unique_ptr<Simulation<2>> sheared() {
  auto simulation = std::make_unique<Simulation<2>>(vortex_setup(4, cpdi2));
  constexpr double dt = 1e-3;
  for (int k = 0; k < 200; ++k) EXPECT_FALSE(simulation->step(k * dt, dt)) << simulation->state().finding->reason;
  return simulation;
}

// L of the step maps the diagonals of a quadrilateral as the corners move, and its area is half their product.
TEST(Corners, DetFIsTheRatioOfTheAreas) {
  const auto simulation = sheared();
  const State<2>& s = simulation->state();
  double shear = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Mat<2> F;
    for (int c = 0; c < 4; ++c) F[static_cast<std::size_t>(c)] = s.column(Column::deformation_gradient, c)[p];
    const double area = average_over(corners_at(s, p)).volume;
    EXPECT_NEAR(area, determinant<2>(F) * s.column(Column::volume)[p], kept * area);
    shear = std::max(shear, std::hypot(F[1], F[2]));
  }
  EXPECT_GT(shear, largest_shear_of_the_run);
}

// What neighbours share begins at the same place, to round-off, and is moved by the same velocity.
TEST(Corners, NeighboursKeepTheCornersThatTheyShare) {
  const auto simulation = sheared();
  const State<2>& s = simulation->state();
  std::map<std::pair<long, long>, Vec<2>> seen;
  const auto& half = s.setup.seeds.half_size;
  std::size_t shared = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Corners<2> corners = corners_at(s, p);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto at = [&](std::size_t d) {
        const double X = s.column(Column::reference_position, static_cast<int>(d))[p];
        return std::lround((X + ((c >> d & 1) ? half[d] : -half[d])) / half[d]);
      };
      const auto [other, is_new] = seen.try_emplace({at(0), at(1)}, corners[c]);
      if (is_new) continue;
      ++shared;
      for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(other->second[d], corners[c][d], kept);
    }
  }
  EXPECT_GT(shared, s.particles);
}

}  // namespace
}  // namespace assay::mpm::test_corners
