// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/grid/live_nodes.hpp"

#include <gtest/gtest.h>

#include <set>

#include "mpm/mass/mass_matrix.hpp"
#include "mpm/seeding/lattice.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_live_nodes {
namespace {

template <int Dim>
GridGeometry<Dim> wide_grid() {
  GridGeometry<Dim> grid;
  grid.spacing = 0.5;
  grid.count.fill(6);
  grid.count[0] = 3 * nodes_of_tile + 3;
  return grid;
}

template <int Dim>
std::set<std::size_t> nodes_of(const LiveNodes<Dim>& live) {
  std::set<std::size_t> nodes;
  live.each([&](std::size_t i) { EXPECT_TRUE(nodes.insert(i).second) << i; });
  EXPECT_EQ(live.count(), nodes.size());
  return nodes;
}

/// All nodes of the tiles that have one in a box, found node by node.
template <int Dim>
std::set<std::size_t> nodes_by_hand(const GridGeometry<Dim>& grid, const std::vector<NodeBox<Dim>>& boxes) {
  std::set<std::size_t> nodes;
  for (std::size_t i = 0; i < grid.nodes(); ++i) {
    for (const NodeBox<Dim>& box : boxes) {
      std::size_t rest = i;
      bool inside = true;
      for (std::size_t d = 0; d < Dim; ++d) {
        auto at = static_cast<std::int32_t>(rest % static_cast<std::size_t>(grid.count[d]));
        rest /= static_cast<std::size_t>(grid.count[d]);
        if (d == 0) {
          const std::int32_t tile = at / nodes_of_tile * nodes_of_tile;
          inside = inside && tile < box.end[d] && tile + nodes_of_tile > box.first[d];
        } else {
          inside = inside && at >= box.first[d] && at < box.end[d];
        }
      }
      if (inside) nodes.insert(i);
    }
  }
  return nodes;
}

template <int Dim>
void expect_tiles_of_boxes() {
  const GridGeometry<Dim> grid = wide_grid<Dim>();
  LiveNodes<Dim> live(grid);
  EXPECT_EQ(live.count(), 0u);
  std::uint32_t random = 1;
  const auto below = [&](std::int32_t n) {
    random = random * 1664525u + 1013904223u;
    return static_cast<std::int32_t>((random >> 16) % static_cast<std::uint32_t>(n));
  };
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<NodeBox<Dim>> boxes(static_cast<std::size_t>(below(4)));
    for (auto& box : boxes) {
      for (std::size_t d = 0; d < Dim; ++d) {
        box.first[d] = below(grid.count[d]);
        box.end[d] = box.first[d] + 1 + below(grid.count[d] - box.first[d]);
      }
    }
    live.forget();
    for (const auto& box : boxes) live.mark(box);
    live.merge();
    const std::set<std::size_t> nodes = nodes_of(live);
    ASSERT_EQ(nodes, nodes_by_hand(grid, boxes));
    for (std::size_t i = 0; i < grid.nodes(); ++i) ASSERT_EQ(live.holds(i), nodes.contains(i));
    for (std::size_t k = 1; k < live.runs().size(); ++k) ASSERT_GT(live.runs()[k].first, live.runs()[k - 1].end);
  }
}

TEST(LiveNodes, AreTheTilesOfTheBoxes) {
  expect_tiles_of_boxes<2>();
  expect_tiles_of_boxes<3>();
}

TEST(LiveNodes, KeptTilesStayAndASingleNodeBringsItsTile) {
  LiveNodes<2> live(wide_grid<2>());
  const std::size_t across = 3 * nodes_of_tile + 3, kept = 2 * across + 1, marked = 4 * across + across - 1;
  live.keep(kept);
  live.merge();
  EXPECT_EQ(*nodes_of(live).begin(), 2 * across);
  EXPECT_EQ(live.count(), static_cast<std::size_t>(nodes_of_tile));
  live.mark(marked);
  live.merge();
  EXPECT_EQ(live.count(), static_cast<std::size_t>(nodes_of_tile) + 3);  // the last tile of a line is short
  EXPECT_TRUE(live.holds(marked));
  live.forget();
  live.merge();
  EXPECT_FALSE(live.holds(marked));
  EXPECT_TRUE(live.holds(kept));
}

/// With more nodes beyond the upper ends: where the first one lies decides how positions are rounded.
template <int Dim>
Setup<Dim> in_wider_grid(Setup<Dim> setup, std::int32_t more) {
  for (auto& count : setup.grid.count) count += more;
  return setup;
}

struct EveryMethodOnTiles : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, EveryMethodOnTiles, testing::ValuesIn(all_methods()), way_name);

// What lies around the body costs nothing and changes nothing: nodes outside the live tiles keep what `allocate` gave
// them, inertia and force of those that died are zero again.
TEST_P(EveryMethodOnTiles, OnlyTilesOfParticlesAreWritten) {
  constexpr int steps = 12;
  constexpr double dt = 1e-3;
  mpm::Setup<2> setup = in_wider_grid(block_setup<2>(GetParam()), 40);
  setup.threads = 2;
  setup.initial_velocity.emplace();
  setup.initial_velocity->velocity = {40, -3};  // five cells in all
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  std::set<std::size_t> ever;
  for (int k = 0; k < steps; ++k) {
    ASSERT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
    s.live.each([&](std::size_t i) { ever.insert(i); });
    double mass = 0, all = 0;
    s.live.each([&](std::size_t i) { mass += s.inertia.node(i)[0]; });
    for (std::size_t i = 0; i < s.inertia.nodes(); ++i) {
      all += s.inertia.node(i)[0];
      if (s.live.holds(i)) continue;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(s.inertia.node(i)[c], 0) << "step " << k << ", node " << i;
      for (int c = 0; c < 2; ++c) ASSERT_EQ(s.force.node(i)[c], 0) << "step " << k << ", node " << i;
    }
    EXPECT_EQ(mass, all);
    EXPECT_GT(mass, 0);
  }
  EXPECT_LT(ever.size(), s.inertia.nodes() / 4);
  for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
    if (ever.contains(i)) continue;
    for (int c = 0; c < 4; ++c) ASSERT_EQ(s.motion.node(i)[c], 0);
    for (const auto& field : s.template own<SolverFields<2>>().vectors) {
      for (int c = 0; c < 2; ++c) ASSERT_EQ(field.node(i)[c], 0);
    }
  }
}

TEST_P(EveryMethodOnTiles, AreToldBeforeARunBegins) {
  const mpm::Setup<2> setup = vortex_setup(6, GetParam());
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  EXPECT_FALSE(simulation.step(0, 1e-3)) << s.finding->reason;
  EXPECT_EQ(nodes_reached(setup), s.live.count());
}

TEST_P(EveryMethodOnTiles, AWiderGridChangesNoBit) {
  constexpr int steps = 8;
  constexpr double dt = 1e-3;
  const auto positions = [&](std::int32_t more) {
    Simulation<2> simulation(in_wider_grid(vortex_setup(5, GetParam()), more));
    State<2>& s = simulation.state();
    for (int k = 0; k < steps; ++k) EXPECT_FALSE(simulation.step(k * dt, dt)) << s.finding->reason;
    std::vector<double> found;
    for (int d = 0; d < 2; ++d) {
      found.insert(found.end(), s.column(Column::position, d), s.column(Column::position, d) + s.particles);
    }
    return found;
  };
  const std::vector<double> narrow = positions(0), wide = positions(3 * nodes_of_tile + 1);
  if (GetParam().mass != Mass::consistent || !GetParam().is_total()) {
    EXPECT_EQ(narrow, wide);
    return;
  }
  for (std::size_t k = 0; k < narrow.size(); ++k) {  // conjugate gradients, with the mean matrix of the whole grid
    EXPECT_NEAR(narrow[k], wide[k], 1e3 * converged);
  }
}

}  // namespace
}  // namespace assay::mpm::test_live_nodes
