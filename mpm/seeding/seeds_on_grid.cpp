// SPDX-License-Identifier: BSD-3-Clause
// Particles in the order of the nodes that they reach.
#include "mpm/seeding/lattice.hpp"

#include <algorithm>
#include <numeric>

#include "mpm/data/blocks.hpp"
#include "mpm/grid/images.hpp"
#include "mpm/grid/live_nodes.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

template <class B>
bool place(B& basis, const std::array<double, 2>& X, const Mat<2>& half) {
  if constexpr (B::traits.moves_corners) {
    return basis.place(0, corners_of<2>(X, half));
  } else if constexpr (B::domain_components == 4) {
    return basis.place(0, X, {1, 0, 0, 1}, half);
  } else {
    return basis.place(0, X, {1, 0, 0, 1});
  }
}

/// The first node of each particle; empty where there is none.
template <class B>
std::vector<std::int32_t> first_nodes(const Setup<2>& setup) {
  std::vector<std::int32_t> found;
  if constexpr (B::nodes_across > 0) {
    const Seeds<2>& seeds = setup.seeds;
    B basis(setup.grid, seeds.half_size, 1);
    typename B::Nodes nodes;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      basis.place(0, {seeds.X[0][p], seeds.X[1][p]}, {1, 0, 0, 1});
      basis.expand(0, 1, nodes);
      found.push_back(nodes.node[0]);
    }
  }
  return found;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& order) {
  if (values.empty()) return;
  std::vector<T> permuted;
  permuted.reserve(values.size());
  for (const std::size_t p : order) permuted.push_back(values[p]);
  values = std::move(permuted);
}

}  // namespace

std::size_t nodes_reached(const Setup<2>& setup) {
  LiveNodes<2> live(setup.grid);
  const Seeds<2>& seeds = setup.seeds;
  const Mat<2> alike{seeds.half_size[0], 0, 0, seeds.half_size[1]};
  with_basis<2>(setup.method.basis, [&](auto tag) {
    typename decltype(tag)::type basis(setup.grid, seeds.half_size, 1);
    const auto include = [&](NodeBox<2>& all, const std::array<double, 2>& X, const Mat<2>& half) {
      if (!place(basis, X, half)) return;
      NodeBox<2> box;
      basis.reach(0, 1, box);
      all.include(box);
    };
    for (std::size_t begin = 0; begin < seeds.size(); begin += block_size) {
      NodeBox<2> box;
      for (std::size_t p = begin; p < std::min(seeds.size(), begin + block_size); ++p) {
        include(box, {seeds.X[0][p], seeds.X[1][p]}, seeds.half_edges.empty() ? alike : seeds.half_edges[p]);
      }
      live.mark(box);
    }
    for (const auto& X : seeds.held) {
      NodeBox<2> box;
      include(box, {X[0], X[1]}, alike);
      live.mark(box);
    }
  });
  if (setup.has_images()) mark_images(live, Images<2>(setup.grid, setup.ends));
  live.merge();
  return live.count();
}

void order_by_nodes(Setup<2>& setup) {
  Seeds<2>& seeds = setup.seeds;
  if (!seeds.half_edges.empty()) return;
  const std::vector<std::int32_t> node =
      with_basis<2>(setup.method.basis, [&](auto tag) { return first_nodes<typename decltype(tag)::type>(setup); });
  if (node.empty()) return;
  std::vector<std::size_t> order(seeds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return node[a] < node[b]; });
  for (auto& X : seeds.X) permute(X, order);
  permute(seeds.volumes, order);
  std::vector<std::uint32_t> place(seeds.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::uint32_t>(k);
  for (SurfaceEdge& edge : seeds.surface) edge.particle = place[edge.particle];
  if (!seeds.domains) return;
  ReferenceDomains domains = *seeds.domains;
  permute(domains.places, order);
  seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
}

}  // namespace assay::mpm
