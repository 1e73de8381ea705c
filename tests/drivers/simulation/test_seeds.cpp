// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/problem.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_seeds {
namespace {

mpm::Seeds<2> seeds(const std::string& body, const std::string& method = "{basis: bspline2}") {
  return seeds_of(scene_from_text(scene_text("body: " + body + "\ngrid: {spacing: 0.125}\nmethod: " + method + "\n"),
                                  "f.yaml", {}));
}

TEST(Seeds, OfAGaussLatticeFillTheSquareHeldOnesIncluded) {
  for (const std::string outside : {"held", "free"}) {
    for (const std::string per_cell : {"[2, 2]", "[3, 2]"}) {
      const auto s = seeds("{domain: square, lattice: gauss, outside: " + outside + ", per_cell: " + per_cell + "}");
      double volume = std::accumulate(s.volumes.begin(), s.volumes.end(), 0.0);
      for (std::size_t k = 0; k < s.held.size(); ++k) volume += s.held_volume(k);
      EXPECT_NEAR(volume, 9, 1e-12);
      EXPECT_EQ(s.held.empty(), outside == "free");
      double area = 0;  // whose part in the ring bears the force: none of it is held
      for (const auto& place : s.domains->places) area += moments_of(s.domains->shapes[place.shape].boundary).area;
      EXPECT_NEAR(area, 3.14159265358979324, 1e-12);
    }
  }
}

TEST(Seeds, OfAJitteredLatticeKeepTheVolumesAndTheDomainsOfTheCartesianOne) {
  for (const std::string body : {"lattice: jittered", "domain: square, lattice: jittered"}) {
    const auto moved = seeds("{" + body + ", seed: 4}"), again = seeds("{" + body + ", seed: 4}");
    const auto other = seeds("{" + body + ", seed: 5}"), still = seeds("{" + body + ", jitter: 1e-300}");
    EXPECT_EQ(moved.X, again.X);
    EXPECT_NE(moved.X, other.X);
    EXPECT_EQ(moved.volumes, still.volumes);
    ASSERT_EQ(moved.domains->places.size(), still.domains->places.size());
    for (std::size_t p = 0; p < moved.size(); ++p) {
      EXPECT_EQ(moved.domains->places[p].shape, still.domains->places[p].shape);
      for (std::size_t d = 0; d < 2; ++d) {
        EXPECT_LT(std::abs(moved.X[d][p] - still.X[d][p]), 0.25 * 2 * moved.half_size[d]);
      }
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_seeds
