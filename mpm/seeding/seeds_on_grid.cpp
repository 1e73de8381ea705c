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

template <int Dim>
Mat<Dim> diagonal_of(const std::array<double, Dim>& values) {
  Mat<Dim> found{};
  for (std::size_t d = 0; d < Dim; ++d) found[d * (Dim + 1)] = values[d];
  return found;
}

template <int Dim>
Mat<Dim> no_deformation() {
  std::array<double, Dim> ones;
  ones.fill(1);
  return diagonal_of<Dim>(ones);
}

template <int Dim>
std::array<double, Dim> place_of(const Seeds<Dim>& seeds, std::size_t p) {
  std::array<double, Dim> X;
  for (std::size_t d = 0; d < Dim; ++d) X[d] = seeds.X[d][p];
  return X;
}

template <class B, int Dim>
bool place(B& basis, const std::array<double, Dim>& X, const Mat<Dim>& half) {
  if constexpr (B::traits.moves_corners) {
    return basis.place(0, corners_of<Dim>(X, half));
  } else if constexpr (B::domain_components == Dim * Dim) {
    return basis.place(0, X, no_deformation<Dim>(), half);
  } else {
    return basis.place(0, X, no_deformation<Dim>());
  }
}

/// The first node of each particle; empty where there is none.
template <class B, int Dim>
std::vector<std::int32_t> first_nodes(const Setup<Dim>& setup) {
  std::vector<std::int32_t> found;
  if constexpr (B::nodes_across > 0) {
    const Seeds<Dim>& seeds = setup.seeds;
    B basis(setup.grid, seeds.half_size, 1);
    typename B::Nodes nodes;
    for (std::size_t p = 0; p < seeds.size(); ++p) {
      basis.place(0, place_of(seeds, p), no_deformation<Dim>());
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

/// What the force is averaged over, in the order of the particles.
template <int Dim>
void order_domains(Seeds<Dim>& seeds, const std::vector<std::size_t>& order) {
  auto domains = *seeds.domains;
  if constexpr (Dim == 2) {
    permute(domains.places, order);
  } else {
    std::vector<std::array<Vector3, 8>> permuted;
    for (const std::size_t p : order) {
      auto& corners = permuted.emplace_back();
      for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = domains.corners()[domains.domains()[p].corners[k]];
    }
    domains = Hexahedra(permuted);
  }
  seeds.domains = std::make_shared<const decltype(domains)>(std::move(domains));
}

}  // namespace

template <int Dim>
std::size_t nodes_reached(const Setup<Dim>& setup) {
  LiveNodes<Dim> live(setup.grid);
  const Seeds<Dim>& seeds = setup.seeds;
  const Mat<Dim> alike = diagonal_of<Dim>(seeds.half_size);
  with_basis<Dim>(setup.method.basis, [&](auto tag) {
    using B = typename decltype(tag)::type;
    B basis(setup.grid, seeds.half_size, 1);
    const auto include = [&](NodeBox<Dim>& all, const std::array<double, Dim>& X, const Mat<Dim>& half) {
      if (!place<B, Dim>(basis, X, half)) return;
      NodeBox<Dim> box;
      basis.reach(0, 1, box);
      all.include(box);
    };
    for (std::size_t begin = 0; begin < seeds.size(); begin += block_size) {
      NodeBox<Dim> box;
      for (std::size_t p = begin; p < std::min(seeds.size(), begin + block_size); ++p)
        include(box, place_of(seeds, p), seeds.half_edges.empty() ? alike : seeds.half_edges[p]);
      live.mark(box);
    }
    for (const auto& X : seeds.held) {
      NodeBox<Dim> box;
      include(box, X, alike);
      live.mark(box);
    }
  });
  if (setup.has_images()) mark_images(live, Images<Dim>(setup.grid, setup.ends));
  live.merge();
  return live.count();
}

template <int Dim>
void order_by_nodes(Setup<Dim>& setup) {
  Seeds<Dim>& seeds = setup.seeds;
  if (!seeds.half_edges.empty()) return;
  const std::vector<std::int32_t> node = with_basis<Dim>(
      setup.method.basis, [&](auto tag) { return first_nodes<typename decltype(tag)::type, Dim>(setup); });
  if (node.empty()) return;
  std::vector<std::size_t> order(seeds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return node[a] < node[b]; });
  for (auto& X : seeds.X) permute(X, order);
  permute(seeds.volumes, order);
  std::vector<std::uint32_t> place(seeds.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::uint32_t>(k);
  for (SurfacePiece<Dim>& piece : seeds.surface) piece.particle = place[piece.particle];
  if (seeds.domains) order_domains(seeds, order);
}

template std::size_t nodes_reached(const Setup<ASSAY_DIMENSION>&);
template void order_by_nodes(Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
