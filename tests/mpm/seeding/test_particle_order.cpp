// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "mpm/seeding/lattice.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::test_particle_order {
namespace {

using namespace assay;
using namespace assay::mpm;

std::set<std::array<double, 2>> places_of(const mpm::Setup<2>& setup) {
  std::set<std::array<double, 2>> places;
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) places.insert({setup.seeds.X[0][p], setup.seeds.X[1][p]});
  return places;
}

/// How often the nearest node changes from one particle to the next, and how many nodes are some particle's nearest.
std::pair<std::size_t, std::size_t> changes_of_nearest_node(const mpm::Setup<2>& setup) {
  std::set<std::array<double, 2>> nodes;
  std::array<double, 2> before{1e9, 1e9};
  std::size_t changes = 0;
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    const double h = setup.grid.spacing;
    const std::array<double, 2> node{std::floor(setup.seeds.X[0][p] / h + 0.5),
                                     std::floor(setup.seeds.X[1][p] / h + 0.5)};
    changes += node != before ? 1 : 0;
    nodes.insert(before = node);
  }
  return {changes, nodes.size()};
}

mpm::Setup<2> setup_of(Basis basis) {
  Method method;
  method.basis = basis;
  return vortex_setup(6, method);
}

TEST(ParticleOrder, ParticlesOfTheSameNodesStandTogether) {
  mpm::Setup<2> setup = setup_of(Basis::bspline2);
  const auto places = places_of(setup);
  const auto [before, nodes] = changes_of_nearest_node(setup);
  EXPECT_GT(before, nodes);  // in cell order they do not
  order_by_nodes(setup);
  EXPECT_EQ(changes_of_nearest_node(setup).first, nodes);
  EXPECT_EQ(places_of(setup), places);
}

TEST(ParticleOrder, DomainsAndVolumesGoWithTheirParticles) {
  mpm::Setup<2> setup = setup_of(Basis::bspline2);
  const Annulus ring{0.75, 1.25};
  setup.seeds = clipped_lattice(ring, setup.grid.spacing, {2, 2});
  std::map<std::array<double, 2>, std::pair<double, std::uint32_t>> known;
  const auto at = [&](std::size_t p) { return std::array<double, 2>{setup.seeds.X[0][p], setup.seeds.X[1][p]}; };
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    known[at(p)] = {setup.seeds.volumes[p], setup.seeds.domains->places[p].shape};
  }
  const std::vector<double> first = setup.seeds.X[0];
  order_by_nodes(setup);
  EXPECT_NE(setup.seeds.X[0], first);
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    EXPECT_EQ(known.at(at(p)), std::pair(setup.seeds.volumes[p], setup.seeds.domains->places[p].shape));
  }
}

TEST(ParticleOrder, BasesWithoutAFixedReachStayInCellOrder) {
  mpm::Setup<2> setup = setup_of(Basis::cpdi);
  const std::vector<double> first = setup.seeds.X[0];
  order_by_nodes(setup);
  EXPECT_EQ(setup.seeds.X[0], first);
}

}  // namespace
}  // namespace assay::test_particle_order
