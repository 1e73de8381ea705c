// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/lattice.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "harness/exact/polar.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_lattice {
namespace {

using Point = std::array<double, 2>;

std::set<Point> points_of(const Seeds<2>& seeds) {
  std::set<Point> points;
  for (std::size_t p = 0; p < seeds.size(); ++p) points.insert({seeds.X[0][p], seeds.X[1][p]});
  return points;
}

TEST(Lattice, TheRingOfTheIssueHas5032Particles) {
  const Seeds<2> seeds = vortex_setup(10).seeds;
  EXPECT_EQ(seeds.size(), 5032u);
  EXPECT_EQ(points_of(seeds).size(), 5032u);
  EXPECT_TRUE(seeds.held.empty());
  // the sum of whole squares whose centres lie in the ring: its area up to the boundary's noise
  const double area = std::numbers::pi * (1.25 * 1.25 - 0.75 * 0.75);
  EXPECT_NEAR(static_cast<double>(seeds.size()) * seeds.volume(), area, 2e-3 * area);
}

// Counted over odd integers, without any rounding: X = (2i+1) h / (2 per_cell).
TEST(Lattice, HoldsExactlyTheLatticePointsInsideTheRing) {
  for (const auto& [across, per_cell] :
       {std::pair{10, std::array{1, 1}}, std::pair{10, std::array{3, 2}}, std::pair{20, std::array{2, 2}}}) {
    const Seeds<2> seeds = vortex_setup(across, {}, per_cell).seeds;
    const std::int64_t nx = 2 * per_cell[0], ny = 2 * per_cell[1];
    std::size_t count = 0;
    for (std::int64_t i = -nx * across * 3 - 1; i < nx * across * 3; i += 2) {
      for (std::int64_t j = -ny * across * 3 - 1; j < ny * across * 3; j += 2) {
        // R^2 = (h i / nx)^2 + (h j / ny)^2 with h = 1 / (2 across), against 9/16 and 25/16
        const std::int64_t square = (i * i * ny * ny + j * j * nx * nx) * 16;
        const std::int64_t unit = 4 * nx * nx * ny * ny * across * across;
        if (square > 9 * unit && square < 25 * unit) ++count;
      }
    }
    EXPECT_EQ(seeds.size(), count);
    EXPECT_EQ(seeds.half_size[0], 0.25 / across / per_cell[0]);
    EXPECT_EQ(seeds.half_size[1], 0.25 / across / per_cell[1]);
  }
}

TEST(Lattice, IsSymmetricToTheLastBit) {
  for (const int across : {7, 10, 13}) {  // spacings that are no powers of two
    const auto points = points_of(vortex_setup(across).seeds);
    for (const Point& X : points) {
      EXPECT_TRUE(points.contains({-X[0], X[1]}));
      EXPECT_TRUE(points.contains({X[1], X[0]}));
    }
  }
}

TEST(Lattice, LeavesOutWhatLiesOutsideTheBoxAndKeepsHeldOnesApart) {
  const auto fate = [](const Point& X) { return X[0] < 0 ? Fate::held : Fate::stepped; };
  const Seeds<2> seeds = cartesian_lattice<2>({-0.32, -0.1}, {0.2, 0.13}, 0.1, {2, 2}, fate);
  // x: -.325 is outside, -.275 .. .175; y: -.075 .. .125
  EXPECT_EQ(seeds.size(), 4u * 5u);
  EXPECT_EQ(seeds.held.size(), 6u * 5u);
  for (const Point& X : seeds.held) EXPECT_LT(X[0], 0);
}

TEST(Lattice, GoesCellByCell) {
  const Seeds<2> seeds = cartesian_lattice<2>({0, 0}, {2, 2}, 1, {2, 2}, [](const Point&) { return Fate::stepped; });
  ASSERT_EQ(seeds.size(), 16u);
  for (std::size_t p = 0; p < 16; ++p) {
    EXPECT_EQ(static_cast<std::size_t>(seeds.X[0][p]), p / 4 % 2);
    EXPECT_EQ(static_cast<std::size_t>(seeds.X[1][p]), p / 8);
  }
}

constexpr Annulus ring{0.75, 1.25};
const double ring_area = std::numbers::pi * (1.25 * 1.25 - 0.75 * 0.75);

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

TEST(ClippedLattice, FillsTheRingToRoundOff) {
  for (const double h : {0.05, 0.0437, 0.1, 0.3}) {
    for (const auto& per_cell : {std::array{2, 2}, std::array{3, 2}, std::array{1, 1}}) {
      const Seeds<2> seeds = clipped_lattice(ring, h, per_cell);
      ASSERT_EQ(seeds.volumes.size(), seeds.size());
      // cells with less than 1e-9 of a cell are left out
      EXPECT_NEAR(sum(seeds.volumes), ring_area, 1e-12 * ring_area + 1e-9 * seeds.volume()) << h;
      for (std::size_t p = 0; p < seeds.size(); ++p) {
        EXPECT_GT(seeds.volume(p), 0);
        EXPECT_LE(seeds.volume(p), seeds.volume() * (1 + 1e-12));
        const double R = std::hypot(seeds.X[0][p], seeds.X[1][p]);
        EXPECT_TRUE(h > 0.2 || (R > ring.inner && R < ring.outer)) << R;  // the centroid lies in it
      }
    }
  }
}

TEST(ClippedLattice, HasAParticleWhereverACellReachesIntoTheRing) {
  const double h = 0.05, half = 0.0125;
  const Seeds<2> seeds = clipped_lattice(ring, h, {2, 2});
  std::size_t count = 0, whole = 0;
  for (int i = -60; i < 60; ++i) {
    for (int j = -60; j < 60; ++j) {
      const double x = (2 * i + 1) * half, y = (2 * j + 1) * half;
      const double near = std::hypot(std::abs(x) - half, std::abs(y) - half);
      const double far = std::hypot(std::abs(x) + half, std::abs(y) + half);
      count += far > ring.inner + 1e-9 && near < ring.outer - 1e-9;
      whole += near >= ring.inner && far <= ring.outer;
    }
  }
  EXPECT_EQ(seeds.size(), count);
  EXPECT_GT(seeds.size(), vortex_setup(10).seeds.size());
  std::size_t full = 0;
  for (const double v : seeds.volumes) full += std::abs(v / seeds.volume() - 1) < 1e-12;
  EXPECT_EQ(full, whole);
}

TEST(ClippedLattice, IsSymmetricToTheLastBitUnderQuarterTurns) {
  const auto points = points_of(clipped_lattice(ring, 0.0437, {2, 2}));
  for (const Point& X : points) EXPECT_TRUE(points.contains({-X[1], X[0]}));
}

TEST(PolarLattice, FillsTheRingWithSectorsNoLargerThanACell) {
  for (const double h : {0.05, 0.0437, 0.1, 0.6}) {
    for (const auto& per_cell : {std::array{2, 2}, std::array{3, 2}, std::array{1, 1}}) {
      const Seeds<2> seeds = polar_lattice(ring, h, per_cell);
      ASSERT_EQ(seeds.half_edges.size(), seeds.size());
      EXPECT_NEAR(sum(seeds.volumes), ring_area, 1e-12 * ring_area) << h;
      for (std::size_t p = 0; p < seeds.size(); ++p) {
        const auto& H = seeds.half_edges[p];
        const double X = seeds.X[0][p], Y = seeds.X[1][p], R = std::hypot(X, Y);
        EXPECT_NEAR(4 * (H[0] * H[3] - H[1] * H[2]), seeds.volume(p), 1e-15);    // the domain's volume
        EXPECT_NEAR((H[0] * X + H[2] * Y) / R, std::hypot(H[0], H[2]), 1e-15);   // along E_R
        EXPECT_NEAR((-H[1] * Y + H[3] * X) / R, std::hypot(H[1], H[3]), 1e-15);  // along E_Theta
        EXPECT_LE(2 * std::hypot(H[0], H[2]), h / per_cell[0] * (1 + 1e-9));
        EXPECT_LE(2 * std::hypot(H[1], H[3]), h / per_cell[1] * (1 + 1e-9));
        EXPECT_TRUE(h > 0.2 || 2 * std::hypot(H[1], H[3]) >= 0.9 * h / per_cell[1]);
      }
      EXPECT_EQ(seeds.size() % 4, 0u);
    }
  }
}

TEST(PolarLattice, StandsOnCirclesAtTheCentroidsOfItsSectors) {
  const Seeds<2> seeds = polar_lattice(ring, 0.05, {2, 2});
  const RingPoints points(seeds.X[0], seeds.X[1]);
  ASSERT_EQ(points.radius.size(), 20u);
  std::array<double, 2> first{};
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    for (std::size_t d = 0; d < 2; ++d) first[d] += seeds.volume(p) * seeds.X[d][p];
    const AreaMoments m = moments_of(seeds.domains->shapes[points.ring[p]].boundary);
    EXPECT_NEAR(points.radius[points.ring[p]], m.centroid[0], 1e-14);
  }
  for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(first[d], 0, 1e-14);
}

/// Twice the area of a quadrilateral whose corners come in the order of `Corners`.
double doubled_area(const std::array<Point, 4>& x) {
  return (x[3][0] - x[0][0]) * (x[2][1] - x[1][1]) - (x[3][1] - x[0][1]) * (x[2][0] - x[1][0]);
}

TEST(PolarLattice, NeighboursShareCornersWhereTheyAreAskedTo) {
  Seeds<2> seeds = polar_lattice(ring, 0.05, {4, 1}, true);
  ASSERT_EQ(seeds.corners.size(), seeds.size());
  const std::size_t sectors = seeds.size() / 40;  // rings
  ASSERT_EQ(seeds.size() % 40, 0u);
  EXPECT_NEAR(static_cast<double>(sectors), 2 * M_PI / 0.05, 4);  // one cell wide at the radius 1
  const double angle = 2 * M_PI / static_cast<double>(sectors);
  constexpr double rounding = 1e-14;
  const auto expect_same = [&](const Point& a, const Point& b) {
    for (std::size_t d = 0; d < 2; ++d) EXPECT_NEAR(a[d], b[d], rounding);
  };
  for (const double turned : {0.0, 0.7}) {
    if (turned > 0) turn(seeds, turned, true);
    double area = 0;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      const auto& x = seeds.corners[p];
      const std::size_t next = p % sectors + 1 == sectors ? p + 1 - sectors : p + 1, outer = p + sectors;
      for (std::size_t d = 0; d < 2; ++d) expect_same(x[2 + d], seeds.corners[next][d]);
      for (std::size_t c = 0; c < 2 && outer < seeds.size(); ++c)
        expect_same(x[2 * c + 1], seeds.corners[outer][2 * c]);
      EXPECT_GT(doubled_area(x), 0);
      area += 0.5 * doubled_area(x);
      Point middle{};
      for (const Point& corner : x) middle[0] += 0.25 * corner[0], middle[1] += 0.25 * corner[1];
      EXPECT_LT(std::hypot(middle[0] - seeds.X[0][p], middle[1] - seeds.X[1][p]), 0.002);  // of 0.0125 and 0.05
    }
    EXPECT_NEAR(area, ring_area * std::sin(angle) / angle, 1e-12);  // of the polygons
  }
}

std::array<std::vector<double>, 2> disturbed(double fraction, std::uint64_t seed, Seeds<2> seeds) {
  disturb(seeds, fraction, seed);
  return seeds.X;
}

TEST(Disturb, MovesEachParticleByLessThanTheFractionTheSameWayEveryTime) {
  for (const Seeds<2>& seeds : {vortex_setup(10, {}, {2, 3}).seeds, clipped_lattice(ring, 0.05, {2, 3})}) {
    const auto once = disturbed(0.25, 1, seeds), again = disturbed(0.25, 1, seeds), other = disturbed(0.25, 2, seeds);
    EXPECT_EQ(once, again);
    for (std::size_t d = 0; d < 2; ++d) {
      const double most = 0.25 * 2 * seeds.half_size[d];
      double mean = 0, square = 0, largest = 0;
      std::size_t same = 0;
      for (std::size_t p = 0; p < seeds.size(); ++p) {
        const double way = once[d][p] - seeds.X[d][p];
        mean += way / most, square += way * way / (most * most), largest = std::max(largest, std::abs(way));
        same += once[d][p] == other[d][p];
      }
      const auto count = static_cast<double>(seeds.size());
      EXPECT_LT(largest, most * (1 + 1e-12));
      EXPECT_GT(largest, 0.99 * most);
      EXPECT_NEAR(mean / count, 0, 5 / std::sqrt(3 * count));  // five standard deviations of an even distribution
      EXPECT_NEAR(square / count, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / count));
      EXPECT_EQ(same, 0u);
    }
  }
}

// The hash is one of integers: its first values, worked out apart from it, hold on every machine.
TEST(Disturb, IsTheSameOnAllMachines) {
  Seeds<2> seeds;
  seeds.half_size.fill(0.5);
  seeds.X = {std::vector<double>(2, 0.0), std::vector<double>(2, 0.0)};
  disturb(seeds, 0.5, 1);
  EXPECT_EQ(seeds.X[0], (std::vector<double>{-0.13181048434833043, 0.23769925269011705}));
  EXPECT_EQ(seeds.X[1], (std::vector<double>{0.414022462870303, 0.026717995571827857}));
}

TEST(Disturb, MovesHeldParticlesTooAndLeavesVolumesAndDomains) {
  Seeds<2> seeds = cartesian_lattice<2>({-0.2, -0.2}, {0.2, 0.2}, 0.1, {2, 2},
                                        [](const Point& X) { return X[0] < 0 ? Fate::held : Fate::stepped; });
  const Seeds<2> before = seeds;
  disturb(seeds, 0.5, 3);
  for (std::size_t k = 0; k < seeds.held.size(); ++k) {
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_NE(seeds.held[k][d], before.held[k][d]);
      EXPECT_LT(std::abs(seeds.held[k][d] - before.held[k][d]), 0.025);
    }
  }
  Seeds<2> clipped = clipped_lattice(ring, 0.1, {2, 2});
  const auto domains = clipped.domains;
  const std::vector<double> volumes = clipped.volumes;
  disturb(clipped, 0.5, 3);
  EXPECT_EQ(clipped.domains, domains);
  EXPECT_EQ(clipped.volumes, volumes);
}

/// Turned particles stand where the domains of the averaged force are, and the basis's domains turn with them.
TEST(Turn, TakesParticlesAndDomainsAlong) {
  for (Seeds<2> seeds : {clipped_lattice(ring, 0.1, {2, 3}), polar_lattice(ring, 0.1, {2, 2})}) {
    const Seeds<2> before = seeds;
    turn(seeds, 0.7, true);
    const double c = std::cos(0.7), s = std::sin(0.7);
    EXPECT_EQ(seeds.volumes, before.volumes);
    ASSERT_EQ(seeds.half_edges.size(), seeds.size());
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      EXPECT_NEAR(seeds.X[0][p], c * before.X[0][p] - s * before.X[1][p], 1e-15);
      EXPECT_NEAR(seeds.X[1][p], s * before.X[0][p] + c * before.X[1][p], 1e-15);
      const auto& place = seeds.domains->places[p];
      const Point centroid = place.turned(moments_of(seeds.domains->shapes[place.shape].boundary).centroid);
      EXPECT_NEAR(seeds.X[0][p], centroid[0], 1e-13);
      EXPECT_NEAR(seeds.X[1][p], centroid[1], 1e-13);
      const std::array<double, 4> H = before.half_edges.empty()
                                          ? std::array{before.half_size[0], 0.0, 0.0, before.half_size[1]}
                                          : before.half_edges[p];
      const std::array<double, 4> turned{c * H[0] - s * H[2], c * H[1] - s * H[3], s * H[0] + c * H[2],
                                         s * H[1] + c * H[3]};
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(seeds.half_edges[p][k], turned[k], 1e-16);
    }
  }
}

TEST(Turn, BoxesAlongTheAxesKeepTheirVolume) {
  Seeds<2> seeds = vortex_setup(5, {}, {2, 2}).seeds, oblong = vortex_setup(5, {}, {2, 3}).seeds;
  const auto half = seeds.half_size;
  const double volume = oblong.volume();
  turn(seeds, 0.7, false);
  turn(oblong, 0.7, false);
  EXPECT_TRUE(seeds.half_edges.empty());
  EXPECT_EQ(seeds.half_size, half);
  EXPECT_EQ(oblong.half_size[0], oblong.half_size[1]);
  EXPECT_NEAR(oblong.volume(), volume, 1e-15 * volume);
}

TEST(Lattice, TheGridHasItsNodesAtMultiplesOfTheSpacing) {
  const auto grid = grid_around<2>({-1.5, -0.3}, {1.5, 0.31}, 0.1, 4);
  EXPECT_EQ(grid.first, (std::array<std::int32_t, 2>{-19, -7}));
  EXPECT_EQ(grid.count, (std::array<std::int32_t, 2>{39, 16}));  // to 19 and to 8
  EXPECT_EQ(grid.nodes(), 39u * 16u);
  EXPECT_DOUBLE_EQ(grid.coordinate(0, 0), -1.9);
  EXPECT_DOUBLE_EQ(grid.coordinate(1, 15), 0.8);
}

}  // namespace
}  // namespace assay::mpm::test_lattice
