// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/gauss_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace assay::mpm::test_gauss_lattice {
namespace {

using Point = std::array<double, 2>;
constexpr double round_off = 1e-14;  ///< a few units in the last place of sums of order one

Fate always(const Point&) { return Fate::stepped; }

/// Integral of x^a y^b over [0, h]^2, by the particles' volumes.
double integral(const Seeds<2>& seeds, int a, int b) {
  double sum = 0;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    sum += seeds.volume(p) * std::pow(seeds.X[0][p], a) * std::pow(seeds.X[1][p], b);
  }
  return sum;
}

TEST(GaussLattice, IntegratesPolynomialsOverACellToTheirDegreeAndNoFurther) {
  for (const auto& per_cell : {std::array{1, 1}, {2, 2}, {3, 2}, {1, 4}, {5, 3}, {16, 16}}) {
    const Seeds<2> seeds = gauss_lattice({0, 0}, {1, 1}, 1, per_cell, always);
    ASSERT_EQ(seeds.size(), static_cast<std::size_t>(per_cell[0] * per_cell[1]));
    const int last_x = 2 * per_cell[0] - 1, last_y = 2 * per_cell[1] - 1;
    for (int a = 0; a <= last_x; ++a) {
      for (int b = 0; b <= last_y; ++b) EXPECT_NEAR(integral(seeds, a, b), 1.0 / ((a + 1) * (b + 1)), round_off);
    }
    if (per_cell[0] > 5) continue;  // the next degree's error is lost in round-off
    EXPECT_GT(std::abs(integral(seeds, last_x + 1, 0) - 1.0 / (last_x + 2)), 1e3 * round_off);
    EXPECT_GT(std::abs(integral(seeds, 0, last_y + 1) - 1.0 / (last_y + 2)), 1e3 * round_off);
  }
}

TEST(GaussLattice, FillsTheBodyAndStandsAsTheCellsDo) {
  const double h = 0.0437;
  const Seeds<2> seeds = gauss_lattice<2>({-6 * h, -4 * h}, {6 * h, 3 * h}, h, {3, 2}, always);
  EXPECT_EQ(seeds.size(), 12u * 7u * 6u);
  EXPECT_NEAR(integral(seeds, 0, 0), 12 * 7 * h * h, round_off);
  std::set<Point> points;
  for (std::size_t p = 0; p < seeds.size(); ++p) points.insert({seeds.X[0][p], seeds.X[1][p]});
  for (const Point& X : points) EXPECT_TRUE(points.contains({-X[0], X[1]}));  // to the last bit
  for (std::size_t p = 0; p + 6 <= seeds.size(); p += 6) {
    double mass = 0;
    for (std::size_t k = 0; k < 6; ++k) mass += seeds.volume(p + k);
    EXPECT_NEAR(mass, h * h, round_off);
  }
}

TEST(GaussLattice, ItsRectanglesTileTheCellsAroundTheirPoints) {
  const double h = 0.3;
  for (const auto& per_cell : {std::array{1, 1}, {2, 2}, {3, 4}, {16, 7}}) {
    const GaussCells cells(h, per_cell);
    const Seeds<2> seeds = gauss_lattice<2>({-h, -h}, {h, h}, h, per_cell, always);
    std::array<std::set<double>, 2> lower, upper;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      const Point X{seeds.X[0][p], seeds.X[1][p]};
      const Rectangle r = cells.box_around(X);
      EXPECT_NEAR(r.area(), seeds.volume(p), round_off);
      for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_LT(r.lower[d], X[d]);
        EXPECT_LT(X[d], r.upper[d]);
        lower[d].insert(r.lower[d]), upper[d].insert(r.upper[d]);
      }
    }
    for (std::size_t d = 0; d < 2; ++d) {  // each ends where the next one begins, to the last bit
      EXPECT_EQ(lower[d].size(), 2u * static_cast<std::size_t>(per_cell[d]));
      EXPECT_EQ(std::set(std::next(lower[d].begin()), lower[d].end()),
                std::set(upper[d].begin(), std::prev(upper[d].end())));
    }
  }
}

TEST(GaussLattice, HeldParticlesHaveTheirWeightsToo) {
  const double h = 0.1;
  const auto left = [](const Point& X) { return X[0] < 0 ? Fate::held : Fate::stepped; };
  const Seeds<2> seeds = gauss_lattice<2>({-2 * h, 0}, {h, h}, h, {3, 3}, left);
  ASSERT_EQ(seeds.held.size(), 18u);
  double volume = 0;
  for (std::size_t k = 0; k < seeds.held.size(); ++k) volume += seeds.held_volume(k);
  EXPECT_NEAR(volume, 2 * h * h, round_off);
  EXPECT_NEAR(seeds.held_volume(0), 25.0 / 324 * h * h, round_off);  // (5/18)^2
}

TEST(GaussLattice, TheDomainsOfTheAverageFillTheRing) {
  const Annulus ring{0.75, 1.25};
  const double h = 0.125;
  for (const auto& per_cell : {std::array{2, 2}, {3, 2}}) {
    const Seeds<2> seeds = gauss_lattice<2>({-1.5, -1.5}, {1.5, 1.5}, h, per_cell, always);
    const ReferenceDomains domains = gauss_domains(seeds, GaussCells(h, per_cell), ring);
    double area = 0;
    ASSERT_EQ(domains.places.size(), seeds.size());
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      const auto& shape = domains.shapes[domains.places[p].shape];
      EXPECT_NEAR(shape.volume, seeds.volume(p), round_off);
      area += moments_of(shape.boundary).area;
    }
    EXPECT_NEAR(area, std::numbers::pi * (1.25 * 1.25 - 0.75 * 0.75), 1e-12);
  }
}

}  // namespace
}  // namespace assay::mpm::test_gauss_lattice
