// SPDX-License-Identifier: BSD-3-Clause
// Bases whose weights are products of one-dimensional ones on Width neighbouring nodes.
//
// Of a particle is kept what its weights follow from, and they are made again wherever they are asked for: that takes
// less time than reading them back.
#pragma once

#include "mpm/basis/basis.hpp"
#include "mpm/basis/tensor_product.hpp"

namespace assay::mpm {

/// What is kept of a particle without a size: where it is, in cells from the first node.
template <int Dim>
struct PointPlace {
  Vec<Dim> along;
};

/// And of one whose domain is a box along the axes: its half sizes, too [h].
template <int Dim>
struct BoxPlace {
  Vec<Dim> along, half;
};

/// Derived gives place(p, ...), which fills places_[p], and
///   line(p, d, value, slope, first)  weights in a direction, the first of them that of node `first`; no branches
///   fold(d, first, value, slope)     where they reach over the grid's edge (may_cross_edges), back onto it
template <class Derived, int Dim, int Width, class Place = PointPlace<Dim>>
class SeparableBasis : public BasisOf<Derived, Dim> {
 public:
  static constexpr int nodes_across = Width;
  static constexpr std::size_t domain_components = sizeof(Place) / sizeof(double) - Dim;
  static constexpr std::size_t bytes = sizeof(Place);  ///< of the weights a particle
  using Nodes = Lines<Dim, Width>;

  /// Of particles begin to begin + n - 1, n <= particles_at_once.
  ASSAY_INLINE void expand(std::size_t begin, std::size_t n, Nodes& nodes) const {
    std::int32_t first[Dim][particles_at_once];
    for (std::size_t d = 0; d < Dim; ++d) {
      ASSAY_INDEPENDENT
      for (std::size_t k = 0; k < n; ++k) {
        double value[Width], slope[Width];
        derived().line(begin + k, d, value, slope, first[d][k]);
        for (std::size_t i = 0; i < Width; ++i) nodes.values[d][i][k] = value[i], nodes.others[d][i][k] = slope[i];
      }
      if constexpr (Derived::may_cross_edges) fold_all(d, n, first[d], nodes);
    }
    for (std::size_t k = 0; k < n; ++k) {
      nodes.node[k] = 0;
      for (std::size_t d = 0; d < Dim; ++d) nodes.node[k] += first[d][k] * locator_.stride[d];
    }
  }

  ASSAY_INLINE NodeSteps<Dim> steps() const {
    NodeSteps<Dim> steps;
    for (std::size_t d = 0; d < Dim; ++d) steps.of[d] = static_cast<std::size_t>(locator_.stride[d]);
    return steps;
  }

  /// Of a particle along axis d [cells].
  ASSAY_INLINE double along(std::size_t p, std::size_t d) const { return places_[p].along[d]; }

  ASSAY_INLINE void slopes_to_moments(std::size_t n, Nodes& nodes) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      ASSAY_INDEPENDENT
      for (std::size_t k = 0; k < n; ++k) {
        double middle = 0;
        for (int i = 1; i < Width; ++i) middle += i * nodes.values[d][i][k];
        for (int i = 0; i < Width; ++i) {
          nodes.others[d][i][k] = nodes.values[d][i][k] * ((i - middle) * locator_.spacing);
        }
      }
    }
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& value, double* field) const {
    add_to_nodes<K, WithSlopes>(nodes, k, value, steps(), field);
  }

  template <int K>
  ASSAY_INLINE void add_affine(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& value, double* field) const {
    add<K, true>(nodes, k, value, field);
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add_all(const Nodes& nodes, std::size_t n, const Given<K, Dim>& given, double* field) const {
    for (std::size_t k = 0, end = 0; k < n; k = end) {
      end = k + 1;
      if constexpr (Dim == 2) {
        while (end < n && nodes.node[end] == nodes.node[k]) ++end;
        if (end > k + 1) {
          add_run<K, WithSlopes>(nodes, k, end, given, steps(), field);
          continue;
        }
      }
      NodePacks<K, Dim> value;
      given.template get<WithSlopes>(k, value);
      add<K, WithSlopes>(nodes, k, value, field);
    }
  }

  template <int K>
  ASSAY_INLINE void add_all_affine(const Nodes& nodes, std::size_t n, const Given<K, Dim>& given, double* field) const {
    add_all<K, true>(nodes, n, given, field);
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void sum(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found) const {
    sum_over_nodes<K, WithSlopes>(nodes, k, field, steps(), found);
  }

  template <int K, int G>
  ASSAY_INLINE void sum_all(const Nodes& nodes, std::size_t n, const double* field, Taken<K, G, Dim>& taken) const {
    for (std::size_t k = 0; k < n;) {
      if constexpr (Dim == 2) {
        if (k + run_lanes <= n && nodes.node[k] == nodes.node[k + 1] && nodes.node[k] == nodes.node[k + 2] &&
            nodes.node[k] == nodes.node[k + 3]) {
          sum_run<K, G>(nodes, k, field, steps(), taken);
          k += run_lanes;
          continue;
        }
      }
      NodePacks<K, Dim> found;
      sum<K, (G > 0)>(nodes, k, field, found);
      taken.set(k++, found);
    }
  }

  template <int K>
  ASSAY_INLINE Mat<Dim> moment(const Nodes& nodes, std::size_t k, const double* field) const {
    NodePacks<K, Dim> found;
    sum<K, true>(nodes, k, field, found);
    std::array<double, K> value;
    Mat<Dim> moment;
    found.template get<Dim>(value, moment);
    return moment;
  }

  ASSAY_INLINE Mat<Dim> spread(const Nodes& nodes, std::size_t k) const {
    Mat<Dim> D{};
    for (std::size_t d = 0; d < Dim; ++d) {
      double middle = 0, sum = 0;
      for (int i = 1; i < Width; ++i) middle += i * nodes.values[d][i][k];
      for (int i = 0; i < Width; ++i) sum += nodes.values[d][i][k] * (i - middle) * (i - middle);
      D[d * Dim + d] = sum * locator_.spacing * locator_.spacing;
    }
    return D;
  }

  ASSAY_INLINE void reach(std::size_t begin, std::size_t end, NodeBox<Dim>& nodes) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      constexpr std::size_t lanes = 8;
      Extremes<lanes> found(locator_.last_cell[d]);
      std::size_t p = begin;
      for (; p + lanes <= end; p += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) found.include(l, derived().along(p + l, d));
      }
      for (; p < end; ++p) found.include(0, derived().along(p, d));
      const std::int32_t lowest = static_cast<std::int32_t>(found.lowest()) - Width + 1;
      const std::int32_t end_of = static_cast<std::int32_t>(found.highest()) + Width;
      nodes.first[d] = lowest > 0 ? lowest : 0;
      nodes.end[d] = end_of < count_[d] ? end_of : count_[d];
    }
  }

  /// Whether one of particles lies on a line between cells.
  ASSAY_INLINE bool has_on_line(std::size_t begin, std::size_t end) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      constexpr std::size_t lanes = 8;
      Extremes<lanes> found(1);
      const auto include = [&](std::size_t l, double along) {
        const double beyond = along + 0.5;
        const double off = along - static_cast<std::int32_t>(beyond);
        found.include(l, off < 0 ? -off : off);
      };
      std::size_t p = begin;
      for (; p + lanes <= end; p += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) include(l, derived().along(p + l, d));
      }
      for (; p < end; ++p) include(0, derived().along(p, d));
      if (found.lowest() < on_line) return true;
    }
    return false;
  }

 protected:
  explicit SeparableBasis(const GridGeometry<Dim>& grid, std::size_t particles = 0)
      : locator_(grid), count_(grid.count), places_(particles) {}

  Locator<Dim> locator_;
  std::array<std::int32_t, Dim> count_;
  std::vector<Place> places_;

 private:
  ASSAY_INLINE const Derived& derived() const { return static_cast<const Derived&>(*this); }

  ASSAY_INLINE void fold_all(std::size_t d, std::size_t n, std::int32_t* first, Nodes& nodes) const {
    const auto last = static_cast<std::uint32_t>(count_[d] - Width);
    std::uint32_t beyond = 0;
    for (std::size_t k = 0; k < n; ++k) beyond |= static_cast<std::uint32_t>(first[k]) > last ? 1 : 0;
    if (beyond == 0) return;
    for (std::size_t k = 0; k < n; ++k) {
      if (first[k] >= 0 && first[k] + Width <= count_[d]) continue;
      double value[Width], slope[Width];
      for (std::size_t i = 0; i < Width; ++i) value[i] = nodes.values[d][i][k], slope[i] = nodes.others[d][i][k];
      derived().fold(d, first[k], value, slope);
      for (std::size_t i = 0; i < Width; ++i) nodes.values[d][i][k] = value[i], nodes.others[d][i][k] = slope[i];
    }
  }
};

}  // namespace assay::mpm
