// SPDX-License-Identifier: BSD-3-Clause
// Bases whose weights are products of one-dimensional ones on Width neighbouring nodes.
//
// Of a particle is kept what its weights follow from, and they are made again wherever they are asked for: that takes
// less time than reading them back.
#pragma once

#include "mpm/basis.hpp"

namespace assay::mpm {

/// A number for each direction.
template <int Dim>
using DirectionPack = Pack<pack_size(Dim)>;

/// Weights of the nodes in each direction, and what goes with them: their slopes [1/m] or their moments w r [m].
template <int Dim, int Width>
struct Lines {
  DirectionPack<Dim> values[Width], others[Width];
  std::int32_t node = 0;  ///< the first of them

  ASSAY_INLINE double value(std::size_t i, std::size_t d) const { return values[i][d]; }
  ASSAY_INLINE double other(std::size_t i, std::size_t d) const { return others[i][d]; }
};

/// Weights and slopes of neighbouring particles, made together.
template <int Dim, int Width>
struct LinesOfParticles {
  double values[Dim][Width][particles_at_once], slopes[Dim][Width][particles_at_once];
  std::int32_t node[particles_at_once];
};

/// One of them.
template <int Dim, int Width>
struct LinesView {
  const LinesOfParticles<Dim, Width>* all;
  std::size_t k;
  std::int32_t node;

  ASSAY_INLINE double value(std::size_t i, std::size_t d) const { return all->values[d][i][k]; }
  ASSAY_INLINE double other(std::size_t i, std::size_t d) const { return all->slopes[d][i][k]; }
};

/// Derived gives
///   along(p, d)                      where the particle is, in cells from the first node
///   line(p, d, value, slope, first)  weights in a direction, the first of them that of node `first`; no branches
///   fold(d, first, value, slope)     where they reach over the grid's edge (may_cross_edges), back onto it
template <class Derived, int Dim, int Width>
class SeparableBasis {
 public:
  static constexpr int nodes_across = Width;
  using Nodes = LinesOfParticles<Dim, Width>;

  /// Of particles begin to begin + n - 1, n <= particles_at_once.
  ASSAY_INLINE void expand(std::size_t begin, std::size_t n, Nodes& nodes) const {
    std::int32_t first[Dim][particles_at_once];
    for (std::size_t d = 0; d < Dim; ++d) {
      ASSAY_INDEPENDENT
      for (std::size_t k = 0; k < n; ++k) {
        double value[Width], slope[Width];
        derived().line(begin + k, d, value, slope, first[d][k]);
        for (std::size_t i = 0; i < Width; ++i) nodes.values[d][i][k] = value[i], nodes.slopes[d][i][k] = slope[i];
      }
      if constexpr (Derived::may_cross_edges) fold_all(d, n, first[d], nodes);
    }
    for (std::size_t k = 0; k < n; ++k) {
      nodes.node[k] = 0;
      for (std::size_t d = 0; d < Dim; ++d) nodes.node[k] += first[d][k] * locator_.stride[d];
    }
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& value, double* field) const {
    add_to_nodes<K, WithSlopes>(LinesView<Dim, Width>{&nodes, k, nodes.node[k]}, value, field);
  }

  /// Slopes become moments w r [m], for add and sum.
  ASSAY_INLINE void slopes_to_moments(std::size_t n, Nodes& nodes) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      ASSAY_INDEPENDENT
      for (std::size_t k = 0; k < n; ++k) {
        double middle = 0;
        for (int i = 1; i < Width; ++i) middle += i * nodes.values[d][i][k];
        for (int i = 0; i < Width; ++i) {
          nodes.slopes[d][i][k] = nodes.values[d][i][k] * ((i - middle) * locator_.spacing);
        }
      }
    }
  }

  template <int K>
  ASSAY_INLINE void add_affine(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& value, double* field) const {
    add<K, true>(nodes, k, value, field);
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void sum(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found) const {
    sum_over_nodes<K, WithSlopes>(LinesView<Dim, Width>{&nodes, k, nodes.node[k]}, field, found);
  }

  /// Particles begin to end - 1 reach nodes from first to last - 1 in the order of the grid.
  ASSAY_INLINE void reach(std::size_t begin, std::size_t end, std::int32_t& first, std::int32_t& last) const {
    first = last = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      constexpr std::size_t lanes = 8;
      Extremes<lanes> found(locator_.last_cell[d]);
      std::size_t p = begin;
      for (; p + lanes <= end; p += lanes) {
        for (std::size_t l = 0; l < lanes; ++l) found.include(l, derived().along(p + l, d));
      }
      for (; p < end; ++p) found.include(0, derived().along(p, d));
      const std::int32_t lowest = static_cast<std::int32_t>(found.lowest()) - Width + 1;
      const std::int32_t highest = static_cast<std::int32_t>(found.highest()) + Width - 1;
      first += (lowest > 0 ? lowest : 0) * locator_.stride[d];
      last += (highest < count_[d] ? highest : count_[d] - 1) * locator_.stride[d];
    }
    ++last;
  }

  template <int K, int G>
  ASSAY_INLINE void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
                            double* field) const {
    Weights w;
    lines(p, w);
    NodePacks<K, Dim> value;
    value.template set<G>(A, B);
    add_to_nodes<K, (G > 0)>(w, value, field);
  }

  template <int K>
  ASSAY_INLINE void scatter_affine(std::size_t p, const std::array<double, K>& A, const Mat<Dim>& C,
                                   double* field) const {
    Weights w;
    lines(p, w);
    to_moments(w);
    NodePacks<K, Dim> value;
    value.template set<Dim>(A, C);
    add_to_nodes<K, true>(w, value, field);
  }

  template <int K, int G>
  ASSAY_INLINE void gather(std::size_t p, const double* field, std::array<double, K>& value,
                           std::array<double, G * Dim>& gradient) const {
    Weights w;
    lines(p, w);
    NodePacks<K, Dim> found;
    sum_over_nodes<K, (G > 0)>(w, field, found);
    found.template get<G>(value, gradient);
  }

  template <int K>
  ASSAY_INLINE Mat<Dim> first_moment(std::size_t p, const double* field) const {
    Weights w;
    lines(p, w);
    to_moments(w);
    NodePacks<K, Dim> found;
    sum_over_nodes<K, true>(w, field, found);
    std::array<double, K> value;
    Mat<Dim> moment;
    found.template get<Dim>(value, moment);
    return moment;
  }

  ASSAY_INLINE Mat<Dim> second_moment(std::size_t p) const {
    Weights w;
    lines(p, w);
    DirectionPack<Dim> sum{};
    const DirectionPack<Dim> middle = middle_of(w);
    for (int k = 0; k < Width; ++k) {
      const DirectionPack<Dim> r = k - middle;
      sum += w.values[k] * r * r;
    }
    Mat<Dim> D{};
    for (std::size_t d = 0; d < Dim; ++d) D[d * Dim + d] = sum[d] * locator_.spacing * locator_.spacing;
    return D;
  }

  template <int K>
  ASSAY_INLINE void moments(std::size_t p, const double* field, Mat<Dim>& first, Mat<Dim>& second) const {
    first = first_moment<K>(p, field);
    second = second_moment(p);
  }

 protected:
  using Weights = Lines<Dim, Width>;

  explicit SeparableBasis(const GridGeometry<Dim>& grid) : locator_(grid), count_(grid.count) {}

  Locator<Dim> locator_;
  std::array<std::int32_t, Dim> count_;

 private:
  ASSAY_INLINE const Derived& derived() const { return static_cast<const Derived&>(*this); }
  ASSAY_INLINE std::size_t stride(std::size_t d) const { return static_cast<std::size_t>(locator_.stride[d]); }

  ASSAY_INLINE void lines(std::size_t p, Weights& w) const {
    constexpr int S = pack_size(Dim);
    double values[Width][S] = {}, slopes[Width][S] = {};
    w.node = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      double value[Width], slope[Width];
      std::int32_t first = 0;
      derived().line(p, d, value, slope, first);
      if constexpr (Derived::may_cross_edges) {
        if (first < 0 || first + Width > count_[d]) derived().fold(d, first, value, slope);
      }
      for (int i = 0; i < Width; ++i) values[i][d] = value[i], slopes[i][d] = slope[i];
      w.node += first * locator_.stride[d];
    }
    for (int i = 0; i < Width; ++i) load<S>(w.values[i], values[i]), load<S>(w.others[i], slopes[i]);
  }

  ASSAY_INLINE void fold_all(std::size_t d, std::size_t n, std::int32_t* first, Nodes& nodes) const {
    bool crosses = false;
    for (std::size_t k = 0; k < n; ++k) crosses |= first[k] < 0 || first[k] + Width > count_[d];
    if (!crosses) return;
    for (std::size_t k = 0; k < n; ++k) {
      if (first[k] >= 0 && first[k] + Width <= count_[d]) continue;
      double value[Width], slope[Width];
      for (std::size_t i = 0; i < Width; ++i) value[i] = nodes.values[d][i][k], slope[i] = nodes.slopes[d][i][k];
      derived().fold(d, first[k], value, slope);
      for (std::size_t i = 0; i < Width; ++i) nodes.values[d][i][k] = value[i], nodes.slopes[d][i][k] = slope[i];
    }
  }

  /// Of the weights, in nodes from the first.
  ASSAY_INLINE static DirectionPack<Dim> middle_of(const Weights& w) {
    DirectionPack<Dim> middle{};
    for (int k = 1; k < Width; ++k) middle += k * w.values[k];
    return middle;
  }

  ASSAY_INLINE void to_moments(Weights& w) const {
    const DirectionPack<Dim> middle = middle_of(w);
    for (int k = 0; k < Width; ++k) w.others[k] = w.values[k] * ((k - middle) * locator_.spacing);
  }

  template <int K, bool WithOther, class W>
  ASSAY_INLINE void add_to_nodes(const W& w, const NodePacks<K, Dim>& v, double* field) const {
    constexpr int S = GridField<K>::stride;
    double* first = field + static_cast<std::size_t>(w.node) * S;
    for (std::size_t k = 0; k < (Dim == 2 ? 1 : Width); ++k) {
      NodePacks<K, Dim> plane = v;
      if constexpr (Dim == 3) {
        plane.value = w.value(k, 2) * v.value;
        if constexpr (WithOther) {
          plane.value += w.other(k, 2) * v.other[2];
          for (int d = 0; d < 2; ++d) plane.other[d] = w.value(k, 2) * v.other[d];
        }
      }
      for (std::size_t j = 0; j < Width; ++j) {
        double* row = first + (Dim == 3 ? k * stride(Dim - 1) + j * stride(1) : j * stride(1)) * S;
        Pack<S> along = w.value(j, 1) * plane.value, across{};
        if constexpr (WithOther) {
          along += w.other(j, 1) * plane.other[1];
          across = w.value(j, 1) * plane.other[0];
        }
        for (std::size_t i = 0; i < Width; ++i) {
          Pack<S> change = w.value(i, 0) * along;
          if constexpr (WithOther) change += w.other(i, 0) * across;
          assay::mpm::add<S>(row + i * S, change);
        }
      }
    }
  }

  template <int K, bool WithOther, class W>
  ASSAY_INLINE void sum_over_nodes(const W& w, const double* field, NodePacks<K, Dim>& sum) const {
    constexpr int S = GridField<K>::stride;
    const double* first = field + static_cast<std::size_t>(w.node) * S;
    sum = {};
    for (std::size_t k = 0; k < (Dim == 2 ? 1 : Width); ++k) {
      NodePacks<K, Dim> plane{};
      for (std::size_t j = 0; j < Width; ++j) {
        const double* row = first + (Dim == 3 ? k * stride(Dim - 1) + j * stride(1) : j * stride(1)) * S;
        Pack<S> along{}, across{};
        for (std::size_t i = 0; i < Width; ++i) {
          Pack<S> node;
          load<S>(node, row + i * S);
          along += w.value(i, 0) * node;
          if constexpr (WithOther) across += w.other(i, 0) * node;
        }
        plane.value += w.value(j, 1) * along;
        if constexpr (WithOther) {
          plane.other[0] += w.value(j, 1) * across;
          plane.other[1] += w.other(j, 1) * along;
        }
      }
      if constexpr (Dim == 2) {
        sum = plane;
      } else {
        sum.value += w.value(k, 2) * plane.value;
        if constexpr (WithOther) {
          for (int d = 0; d < 2; ++d) sum.other[d] += w.value(k, 2) * plane.other[d];
          sum.other[2] += w.other(k, 2) * plane.value;
        }
      }
    }
  }
};

}  // namespace assay::mpm
