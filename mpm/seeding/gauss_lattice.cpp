// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/gauss_lattice.hpp"

#include <algorithm>
#include <cmath>

namespace assay::mpm {

template <std::size_t N>
GaussCells<N>::GaussCells(double spacing, const std::array<int, N>& per_cell) : half_(0.5 * spacing) {
  for (std::size_t d = 0; d < N; ++d) {
    Axis& axis = axes_[d];
    axis.points = gauss_points(per_cell[d]);
    const std::size_t n = axis.points.size();
    axis.cuts.assign(n + 1, 0);
    for (std::size_t k = 0; 2 * k < n; ++k) {  // from both ends: symmetric to the last bit
      axis.cuts[k] = k == 0 ? -1 : axis.cuts[k - 1] + axis.points[k - 1].weight;
      axis.cuts[n - k] = -axis.cuts[k];
    }
  }
}

template <std::size_t N>
double GaussCells<N>::coordinate(std::size_t d, std::int32_t cell, int k) const {
  return (2.0 * cell + 1 + axes_[d].points[static_cast<std::size_t>(k)].at) * half_;
}

template <std::size_t N>
typename GaussCells<N>::Place GaussCells<N>::place_of(std::size_t d, double x) const {
  const Axis& axis = axes_[d];
  const double middle = 2 * std::floor(x / half_ * 0.5) + 1, at = x / half_ - middle;
  const auto above = std::upper_bound(axis.cuts.begin() + 1, axis.cuts.end() - 1, at);
  return {middle, static_cast<std::size_t>(above - axis.cuts.begin()) - 1};
}

template <std::size_t N>
double GaussCells<N>::volume_at(const std::array<double, N>& X) const {
  double volume = 1;
  for (std::size_t d = 0; d < N; ++d) volume *= half_ * axes_[d].points[place_of(d, X[d]).k].weight;
  return volume;
}

template <std::size_t N>
BoxOfAxes<N> GaussCells<N>::box_around(const std::array<double, N>& X) const {
  BoxOfAxes<N> r;
  for (std::size_t d = 0; d < N; ++d) {
    const Place place = place_of(d, X[d]);
    r.lower[d] = (place.middle + axes_[d].cuts[place.k]) * half_;
    r.upper[d] = (place.middle + axes_[d].cuts[place.k + 1]) * half_;
  }
  return r;
}

template <std::size_t N>
Seeds<int{N}> gauss_lattice(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                            const std::array<int, N>& per_cell, const std::type_identity_t<FateOf<N>>& fate) {
  const GaussCells<N> cells(spacing, per_cell);
  const auto coordinate = [&](std::size_t d, std::int32_t cell, int k) { return cells.coordinate(d, cell, k); };
  Seeds<int{N}> seeds = lattice_of(lower, upper, spacing, per_cell, coordinate, fate);
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    std::array<double, N> X;
    for (std::size_t d = 0; d < N; ++d) X[d] = seeds.X[d][p];
    seeds.volumes.push_back(cells.volume_at(X));
  }
  for (const auto& X : seeds.held) seeds.held_volumes.push_back(cells.volume_at(X));
  return seeds;
}

ReferenceDomains gauss_domains(const Seeds<2>& seeds, const GaussCells<2>& cells, const Annulus& ring) {
  std::vector<Rectangle> rectangles;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    rectangles.push_back(cells.box_around({seeds.X[0][p], seeds.X[1][p]}));
  }
  return domains_of(rectangles, ring, false);
}

template class GaussCells<2>;
template class GaussCells<3>;
template Seeds<2> gauss_lattice(const std::array<double, 2>&, const std::array<double, 2>&, double,
                                const std::array<int, 2>&, const FateOf<2>&);
template Seeds<3> gauss_lattice(const std::array<double, 3>&, const std::array<double, 3>&, double,
                                const std::array<int, 3>&, const FateOf<3>&);

}  // namespace assay::mpm
