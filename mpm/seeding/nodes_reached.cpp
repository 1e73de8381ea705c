// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/nodes_reached.hpp"

#include <algorithm>

#include "mpm/data/blocks.hpp"
#include "mpm/grid/images.hpp"
#include "mpm/grid/live_nodes.hpp"
#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

namespace {

template <class B>
bool place(B& basis, const std::array<double, 2>& X, const Mat<2>& half) {
  if constexpr (MovesCorners<B>) {
    return basis.place(0, corners_of<2>(X, half));
  } else if constexpr (B::domain_components == 4) {
    return basis.place(0, X, {1, 0, 0, 1}, half);
  } else {
    return basis.place(0, X, {1, 0, 0, 1});
  }
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

}  // namespace assay::mpm
