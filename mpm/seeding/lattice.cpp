// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/lattice.hpp"

#include <cmath>

#include "mpm/seeding/cell_counts.hpp"

namespace assay::mpm {

namespace {

/// All bits of the result depend on all bits of x (the finaliser of SplitMix64; Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Between -1 and 1, both excluded: 52 bits of a hash, no rounding.
double noise(std::uint64_t seed, std::uint64_t number) {
  return (static_cast<double>(mixed(mixed(seed) ^ number) >> 12) + 0.5) * 0x1p-51 - 1;
}

/// An edge this close to a face [relative to the body] lies on it.
constexpr double face_rounding = 1e-12;

/// body(cells), the first axis fastest, for all cells from lower to upper - 1.
template <std::size_t N>
void for_cells(const std::array<std::int32_t, N>& lower, const std::array<std::int32_t, N>& upper, const auto& body) {
  for (std::size_t d = 0; d < N; ++d) {
    if (lower[d] >= upper[d]) return;
  }
  std::array<std::int32_t, N> at = lower;
  for (;;) {
    body(at);
    std::size_t d = 0;
    while (d < N && ++at[d] == upper[d]) at[d] = lower[d], ++d;
    if (d == N) return;
  }
}

}  // namespace

template <std::size_t N>
Seeds<int{N}> lattice_of(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                         const std::array<int, N>& per_cell, const CellPoint& coordinate,
                         const std::type_identity_t<FateOf<N>>& fate) {
  Seeds<int{N}> seeds;
  std::array<std::int32_t, N> first, end, none{};
  for (std::size_t d = 0; d < N; ++d) {
    seeds.half_size[d] = 0.5 * spacing / per_cell[d];
    first[d] = cell_below(lower[d], spacing), end[d] = cell_above(upper[d], spacing);
  }
  for_cells<N>(first, end, [&](const auto& cell) {
    for_cells<N>(none, per_cell, [&](const auto& k) {
      std::array<double, N> X;
      for (std::size_t d = 0; d < N; ++d) {
        X[d] = coordinate(d, cell[d], k[d]);
        if (X[d] < lower[d] || X[d] > upper[d]) return;
      }
      const Fate what = fate(X);
      if (what == Fate::held) seeds.held.push_back(X);
      if (what != Fate::stepped) return;
      for (std::size_t d = 0; d < N; ++d) seeds.X[d].push_back(X[d]);
    });
  });
  return seeds;
}

template <std::size_t N>
Seeds<int{N}> cartesian_lattice(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                const std::array<int, N>& per_cell, const std::type_identity_t<FateOf<N>>& fate) {
  // (2 i + 1) half: the same |X| to the last bit on both sides of the origin
  std::array<double, N> half;
  for (std::size_t d = 0; d < N; ++d) half[d] = 0.5 * spacing / per_cell[d];
  const auto coordinate = [&](std::size_t d, std::int32_t cell, int k) {
    return (2.0 * (static_cast<double>(cell) * per_cell[d] + k) + 1) * half[d];
  };
  return lattice_of(lower, upper, spacing, per_cell, coordinate, fate);
}

template <int Dim>
void disturb(Seeds<Dim>& seeds, double fraction, std::uint64_t seed,
             const std::type_identity_t<std::function<bool(const std::array<double, Dim>&)>>& inside) {
  const auto offset = [&](std::size_t particle, std::size_t d) {
    return fraction * 2 * seeds.half_size[d] * noise(seed, Dim * particle + d);
  };
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    std::array<double, Dim> X;
    for (std::size_t d = 0; d < Dim; ++d) X[d] = seeds.X[d][p] + offset(p, d);
    if (inside && !inside(X)) continue;
    for (std::size_t d = 0; d < Dim; ++d) seeds.X[d][p] = X[d];
  }
  for (std::size_t d = 0; d < Dim; ++d) {
    for (std::size_t k = 0; k < seeds.held.size(); ++k) seeds.held[k][d] += offset(seeds.size() + k, d);
  }
}

template <std::size_t N>
GridGeometry<int{N}> grid_around(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                 int margin) {
  GridGeometry<int{N}> grid;
  grid.spacing = spacing;
  for (std::size_t d = 0; d < N; ++d) {
    grid.first[d] = cell_below(lower[d], spacing) - margin;
    grid.count[d] = cell_above(upper[d], spacing) + margin - grid.first[d] + 1;
  }
  return grid;
}

template <std::size_t N>
void add_surface_edges(const BoxOfAxes<N>& body, const std::array<AxisEnds, N>& ends, const BoxOfAxes<N>& domain,
                       std::uint32_t particle, std::vector<SurfacePiece<int{N}>>& pieces) {
  constexpr std::size_t count = SurfacePiece<int{N}>::ends;
  double size = 0;
  for (std::size_t d = 0; d < N; ++d) size += body.upper[d] - body.lower[d];
  for (std::size_t d = 0; d < N; ++d) {
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? body.upper[d] : body.lower[d];
      if (std::abs(at - face) > face_rounding * size || (upper ? ends[d].upper : ends[d].lower)) continue;
      SurfacePiece<int{N}> piece{particle, {}, {}, {}, {}};
      piece.N_dA[d] = upper ? 1 : -1;
      std::array<std::size_t, N> others{};  // the other axes, in their order
      for (std::size_t other = 0, k = 0; other < N; ++other) {
        if (other == d) continue;
        others[k++] = other;
        piece.N_dA[d] *= domain.upper[other] - domain.lower[other];
      }
      for (std::size_t k = 0; k < count; ++k) {
        std::size_t corner = upper ? 1u << d : 0u;
        for (std::size_t bit = 0; bit + 1 < N; ++bit) corner |= (k >> bit & 1u) << others[bit];
        piece.corners[k] = static_cast<std::uint8_t>(corner);
        for (std::size_t i = 0; i < N; ++i) {
          piece.X[k][i] = corner >> i & 1 ? domain.upper[i] : domain.lower[i];
          piece.middle[i] += piece.X[k][i] / static_cast<double>(count);
        }
      }
      pieces.push_back(piece);
    }
  }
}

#define ASSAY_LATTICES_OF(N)                                                                                         \
  template Seeds<N> lattice_of(const std::array<double, N>&, const std::array<double, N>&, double,                   \
                               const std::array<int, N>&, const CellPoint&, const FateOf<N>&);                       \
  template Seeds<N> cartesian_lattice(const std::array<double, N>&, const std::array<double, N>&, double,            \
                                      const std::array<int, N>&, const FateOf<N>&);                                  \
  template void disturb(Seeds<N>&, double, std::uint64_t, const std::function<bool(const std::array<double, N>&)>&); \
  template GridGeometry<N> grid_around(const std::array<double, N>&, const std::array<double, N>&, double, int);     \
  template void add_surface_edges(const BoxOfAxes<N>&, const std::array<AxisEnds, N>&, const BoxOfAxes<N>&,          \
                                  std::uint32_t, std::vector<SurfacePiece<N>>&)
ASSAY_LATTICES_OF(2);
ASSAY_LATTICES_OF(3);
#undef ASSAY_LATTICES_OF

}  // namespace assay::mpm
