// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/library/handles.hpp"

namespace assay::library_test::test_cells {
namespace {

Owned<assay_cells> cells_of(const Owned<assay_problem>& problem, const std::vector<double>& corners, std::size_t n,
                            int wanted = ASSAY_DONE) {
  assay_cells* cells = nullptr;
  assay_error error = ASSAY_ERROR_INIT;
  EXPECT_EQ(assay_cells_open(problem.get(), n, corners.data(), &cells, &error), wanted) << error.message;
  return Owned<assay_cells>(cells);
}

/// A rectangle around a point, counterclockwise.
std::vector<double> rectangle(double X, double Y, double half) {
  return {X - half, Y - half, X + half, Y - half, X + half, Y + half, X - half, Y + half};
}

TEST(Cells, MeansOfSmallOnesAreTheForceInTheirMiddle) {
  constexpr double half = 1e-3, curvature = 1e-4;  // b changes by its second derivative times half^2
  const auto problem = opened(vortex_text());
  const double expected = evaluated(points_at(problem, {.9, .2}, 2), .3, 1).front().b[0];
  const auto cells = cells_of(problem, rectangle(.9, .2, half), 1);
  double b[2], volume = 0;
  const assay_field mean{b, 2, 1};
  ASSERT_EQ(assay_cells_eval(cells.get(), .3, &mean, &volume, nullptr), ASSAY_DONE);
  EXPECT_NEAR(b[0], expected, curvature * std::abs(expected) + curvature);
  EXPECT_NEAR(volume, 4 * half * half, 1e-12);
}

TEST(Cells, OfALatticeAddUpToTheWhole) {
  constexpr int across = 4;
  constexpr double side = .2, alike = 2e-6;  // of Gauss points on the cells' and on the whole's faces
  const auto problem = opened(vortex_text());
  std::vector<double> corners;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < across; ++j) {
      const auto cell = rectangle(.8 + side * (i + .5) / across, side * (j + .5) / across, .5 * side / across);
      corners.insert(corners.end(), cell.begin(), cell.end());
    }
  }
  constexpr std::size_t n = across * across;
  std::vector<double> b(2 * n), volume(n);
  const assay_field means{b.data(), 2, 1};
  ASSERT_EQ(assay_cells_eval(cells_of(problem, corners, n).get(), .3, &means, volume.data(), nullptr), ASSAY_DONE);
  double sum = 0, whole[2];
  for (std::size_t i = 0; i < n; ++i) sum += volume[i] * b[2 * i];
  const assay_field mean{whole, 2, 1};
  const auto one = cells_of(problem, rectangle(.8 + .5 * side, .5 * side, .5 * side), 1);
  ASSERT_EQ(assay_cells_eval(one.get(), .3, &mean, nullptr, nullptr), ASSAY_DONE);
  EXPECT_NEAR(sum / (side * side), whole[0], 1e3 * alike);
}

TEST(Cells, MeansDoNotDependOnTheOthers) {
  const auto problem = opened(vortex_text());
  const std::vector<double> small = rectangle(.9, .2, .05), large = rectangle(-.6, .2, .2);
  std::vector<double> both = small;
  both.insert(both.end(), large.begin(), large.end());
  double alone[2], together[4];
  const assay_field of_one{alone, 2, 1}, of_two{together, 2, 1};
  ASSERT_EQ(assay_cells_eval(cells_of(problem, small, 1).get(), .3, &of_one, nullptr, nullptr), ASSAY_DONE);
  ASSERT_EQ(assay_cells_eval(cells_of(problem, both, 2).get(), .3, &of_two, nullptr, nullptr), ASSAY_DONE);
  for (int d = 0; d < 2; ++d) EXPECT_EQ(alone[d], together[d]);
}

TEST(Cells, ThatTurnTheOtherWayAreRefused) {
  const auto problem = opened(vortex_text());
  cells_of(problem, {.8, .1, .8, .2, .9, .2, .9, .1}, 1, ASSAY_BAD_INPUT);
  cells_of(problem, rectangle(.9, .2, 0), 1, ASSAY_BAD_INPUT);
  cells_of(problem, rectangle(.9, .2, 50), 1, ASSAY_BAD_INPUT);
}

TEST(Cells, InSpaceHaveEightCorners) {
  const auto problem = opened(
      "motion: {type: vortex3d, amplitude: {type: sine, peak: .5}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n"
      "force: {tolerance: 1e-6, cache: false}\n");
  constexpr double h = 1e-2, curvature = 1e-2;
  std::vector<double> corners;
  for (const double z : {-h, h}) {
    for (const auto& [x, y] : {std::pair{-h, -h}, {h, -h}, {h, h}, {-h, h}})
      corners.insert(corners.end(), {.4 + x, .2 + y, .1 + z});
  }
  const std::vector<Fields> exact = evaluated(points_at(problem, {.4, .2, .1}, 3), .3, 1);
  double b[3], volume = 0;
  const assay_field mean{b, 3, 1};
  ASSERT_EQ(assay_cells_eval(cells_of(problem, corners, 1).get(), .3, &mean, &volume, nullptr), ASSAY_DONE);
  EXPECT_NEAR(volume, 8 * h * h * h, 1e-12);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(b[d], exact[0].b[d], curvature * (1 + std::abs(exact[0].b[d])));
}

}  // namespace
}  // namespace assay::library_test::test_cells
