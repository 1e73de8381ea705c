// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/reference_domain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/numeric/gauss.hpp"

namespace assay::test_reference_domain {
namespace {

constexpr Annulus ring{0.75, 1.25};
constexpr double pi = std::numbers::pi;

Rectangle cell(double x, double y, double size) { return {{x, y}, {x + size, y + size}}; }

/// Area and first moments by counting n x n points.
AreaMoments counted(const Rectangle& r, int n) {
  AreaMoments m;
  const double dx = (r.upper[0] - r.lower[0]) / n, dy = (r.upper[1] - r.lower[1]) / n;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Point X{r.lower[0] + (i + 0.5) * dx, r.lower[1] + (j + 0.5) * dy};
      const double R = std::hypot(X[0], X[1]);
      if (R < ring.inner || R > ring.outer) continue;
      m.area += dx * dy;
      for (std::size_t d = 0; d < 2; ++d) m.centroid[d] += dx * dy * X[d];
    }
  }
  for (double& c : m.centroid) c /= m.area;
  return m;
}

TEST(GaussRule, IntegratesPolynomialsOfItsDegreeAndNoMore) {
  const auto moment = [](std::span<const GaussPoint> rule, int degree) {
    double sum = 0;
    for (const GaussPoint& p : rule) sum += p.weight * std::pow(p.at, degree);
    return sum - (degree % 2 ? 0.0 : 2.0 / (degree + 1));
  };
  const auto check = [&](std::span<const GaussPoint> rule) {
    const int n = static_cast<int>(rule.size());
    for (int degree = 0; degree < 2 * n; ++degree) EXPECT_NEAR(moment(rule, degree), 0, 1e-14) << n << " " << degree;
    EXPECT_GT(std::abs(moment(rule, 2 * n)), 1e-6) << n;
    for (int k = 0; k < n; ++k)
      EXPECT_EQ(rule[static_cast<std::size_t>(k)].at, -rule[static_cast<std::size_t>(n - 1 - k)].at);
  };
  check(gauss_rule<1>());
  check(gauss_rule<2>());
  check(gauss_rule<3>());
  check(gauss_rule<5>());
  check(gauss_rule<8>());
}

TEST(ReferenceDomain, ACellInsideTheRingIsItself) {
  const AreaMoments m = moments_of(common_boundary(cell(0.9, 0.1, 0.05), ring));
  EXPECT_NEAR(m.area, 0.0025, 1e-17);
  EXPECT_NEAR(m.centroid[0], 0.925, 1e-15);
  EXPECT_NEAR(m.centroid[1], 0.125, 1e-15);
}

TEST(ReferenceDomain, NothingInCommonIsEmpty) {
  EXPECT_TRUE(common_boundary(cell(0.1, 0.1, 0.05), ring).empty());
  EXPECT_TRUE(common_boundary(cell(1.2, 1.2, 0.05), ring).empty());
  EXPECT_EQ(moments_of({}).area, 0);
}

TEST(ReferenceDomain, AreasAndCentroidsOfClippedCellsAreThoseOfCountedPoints) {
  // each edge of the ring, cut through one, two, three corners, and a cell wide enough for both edges
  for (const Rectangle& r :
       {cell(0.7, 0.1, 0.1), cell(0.5, 0.5, 0.05), cell(0.55, 0.5, 0.05), cell(1.2, 0.0, 0.1), cell(0.85, 0.85, 0.05),
        cell(-0.6, -0.6, 0.1), cell(0.3, 0.3, 0.9), Rectangle{{0.7, -0.1}, {0.8, 0.2}}}) {
    const AreaMoments exact = moments_of(common_boundary(r, ring)), brute = counted(r, 2000);
    EXPECT_NEAR(exact.area, brute.area, 1e-4 * r.area());
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(exact.centroid[d], brute.centroid[d], 1e-4) << r.lower[0];
  }
}

TEST(ReferenceDomain, ASliverHasTheMomentsOfItsSegment) {
  // x > ro - d cuts a segment of half angle acos(1 - d/ro) from the outer circle
  for (const double depth : {1e-3, 1e-6, 1e-9}) {
    const Rectangle r{{ring.outer - depth, -0.2}, {1.4, 0.2}};
    const double half = 2 * std::asin(std::sqrt(0.5 * depth / ring.outer));
    const double area = 2 * ring.outer * ring.outer * std::pow(half, 3) / 3 * (1 - half * half / 5);
    const AreaMoments m = moments_of(common_boundary(r, ring));
    EXPECT_NEAR(m.area, area, 1e-5 * area + 1e-18);
    EXPECT_NEAR(m.centroid[1], 0, 1e-12);
    EXPECT_NEAR((m.centroid[0] - r.lower[0]) / depth, 0.4, 1e-3);  // of a flat parabola
  }
}

// A corner on a circle, where both edges meet it: 3-4-5.
TEST(ReferenceDomain, ACornerOnTheRingsEdgeIsNoTrap) {
  for (const auto& [x, y, part] : {std::tuple{0.45, 0.6, 1.0}, {0.40, 0.55, 0.0}}) {
    const AreaMoments m = moments_of(common_boundary(cell(x, y, 0.05), ring));
    EXPECT_NEAR(m.area, part * 0.0025, 1e-15) << x;
  }
  double sum = 0;
  for (const double x : {0.40, 0.45}) {
    for (const double y : {0.55, 0.6}) sum += moments_of(common_boundary(cell(x, y, 0.05), ring)).area;
  }
  EXPECT_NEAR(sum, moments_of(common_boundary(cell(0.4, 0.55, 0.1), ring)).area, 1e-16);
}

TEST(ReferenceDomain, AreaPointsIntegrateSmoothFunctionsOverClippedCells) {
  const auto f = [](const Point& X) { return std::exp(X[0]) * std::cos(3 * X[1]); };
  for (const Rectangle& r : {cell(0.9, 0.1, 0.05), cell(0.7, 0.1, 0.1), cell(0.5, 0.5, 0.05), cell(0.85, 0.85, 0.05)}) {
    const Boundary boundary = common_boundary(r, ring);
    double sum = 0, area = 0;
    for_each_area_point(boundary, [&](const Point& X, double w) { sum += w * f(X), area += w; });
    EXPECT_NEAR(area, moments_of(boundary).area, 1e-12 * r.area());
    double brute = 0;
    const int n = 2000;
    const double d = (r.upper[0] - r.lower[0]) / n;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const Point X{r.lower[0] + (i + 0.5) * d, r.lower[1] + (j + 0.5) * d};
        const double R = std::hypot(X[0], X[1]);
        if (R > ring.inner && R < ring.outer) brute += d * d * f(X);
      }
    }
    EXPECT_NEAR(sum, brute, 1e-4 * r.area());
    // to high order: against the sum over four quarters of the cell
    double quarters = 0;
    const double half = 0.5 * (r.upper[0] - r.lower[0]);
    for (int k = 0; k < 4; ++k) {
      for_each_area_point(common_boundary(cell(r.lower[0] + (k & 1) * half, r.lower[1] + (k >> 1) * half, half), ring),
                          [&](const Point& X, double w) { quarters += w * f(X); });
    }
    EXPECT_NEAR(sum, quarters, 1e-12 * r.area());
  }
}

TEST(ReferenceDomain, ASectorIsExact) {
  const Sector s{0.8, 0.9, 0.2, 0.5};
  const AreaMoments m = moments_of(boundary_of(s));
  EXPECT_NEAR(m.area, 0.5 * (0.81 - 0.64) * 0.3, 1e-16);
  const double R = 2.0 / 3 * (0.729 - 0.512) / (0.81 - 0.64) * std::sin(0.15) / 0.15;
  EXPECT_NEAR(m.centroid[0], R * std::cos(0.35), 1e-15);
  EXPECT_NEAR(m.centroid[1], R * std::sin(0.35), 1e-15);
}

TEST(ReferenceDomain, ImagesUnderQuarterTurnsShareAShape) {
  std::vector<Rectangle> cells;
  for (int i = -20; i < 20; ++i) {
    for (int j = -20; j < 20; ++j) cells.push_back({{i / 16.0, j / 16.0}, {(i + 1) / 16.0, (j + 1) / 16.0}});
  }
  const ReferenceDomains domains = domains_of(cells, ring, true);
  ASSERT_EQ(domains.places.size(), cells.size());
  EXPECT_EQ(domains.shapes.size(), cells.size() / 4);
  for (std::size_t p = 0; p < cells.size(); ++p) {  // the shape, turned to its place, lies in the cell
    const auto& place = domains.places[p];
    const Boundary& boundary = domains.shapes[place.shape].boundary;
    if (boundary.empty()) continue;
    const Point at = place.turned(moments_of(boundary).centroid);
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_GT(at[d], cells[p].lower[d]);
      EXPECT_LT(at[d], cells[p].upper[d]);
    }
  }
}

TEST(ReferenceDomain, SectorsFillTheirRing) {
  const std::vector<Sector> sectors{{0.75, 1.0, -pi / 8, pi / 8}, {1.0, 1.25, -pi / 12, pi / 12}};
  const std::vector<int> count{8, 12};
  const ReferenceDomains domains = domains_of(sectors, count);
  ASSERT_EQ(domains.places.size(), 20u);
  double volume = 0;
  for (const auto& place : domains.places) volume += domains.shapes[place.shape].volume;
  EXPECT_NEAR(volume, pi * (1.25 * 1.25 - 0.75 * 0.75), 1e-14);
  for (int j = 0; j < 8; ++j) {
    const auto& place = domains.places[static_cast<std::size_t>(j)];
    EXPECT_NEAR(place.cos_turn, std::cos(2 * pi * (j + 0.5) / 8), 1e-15);
    EXPECT_NEAR(place.sin_turn, std::sin(2 * pi * (j + 0.5) / 8), 1e-15);
  }
}

}  // namespace
}  // namespace assay::test_reference_domain
