// SPDX-License-Identifier: BSD-3-Clause
// Bases that weigh the grid's multilinear functions N_i at the corners x_c of a particle's domain:
//   phi_ip = sum_c w_c N_i(x_c),   grad phi_ip = sum_c N_i(x_c) g_c.
#pragma once

#include "mpm/basis/corners.hpp"

namespace assay::mpm {

/// w_c and g_c: component d of g_c stands in gradient[d][c] [1/m].
template <int Dim>
struct CornerWeights {
  std::array<double, 1 << Dim> value;
  std::array<std::array<double, 1 << Dim>, Dim> gradient;
};

/// Derived gives weights(p): CornerWeights.
template <class Derived, int Dim>
class CornerBasis : public BasisOf<Derived, Dim> {
 public:
  static constexpr int corners = 1 << Dim;
  static constexpr int nodes_across = 0;  ///< as its domain is large

  /// Cells of the corners of neighbouring particles.
  struct Nodes {
    std::size_t begin = 0;
    CornerCells<Dim> cells[particles_at_once];
  };
  ASSAY_INLINE void expand(std::size_t begin, std::size_t n, Nodes& nodes) const {
    nodes.begin = begin;
    for (std::size_t k = 0; k < n; ++k) places_.find(begin + k, nodes.cells[k]);
  }
  ASSAY_INLINE void slopes_to_moments(std::size_t, Nodes&) const {}

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& v, double* field) const {
    constexpr int S = GridField<K>::stride;
    decltype(auto) w = derived().weights(nodes.begin + k);
    const Cells& cells = nodes.cells[k];
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<S> value = w.value[c] * v.value;
      if constexpr (WithSlopes) {
        for (std::size_t d = 0; d < Dim; ++d) value += w.gradient[d][c] * v.other[d];
      }
      double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
      for (std::size_t n = 0; n < corners; ++n) {
        assay::mpm::add<S>(places_.template node_of<S>(lower, n), cells.share[n][c] * value);
      }
    }
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add_all(const Nodes& nodes, std::size_t n, const Given<K, Dim>& given, double* field) const {
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<K, Dim> value;
      given.template get<WithSlopes>(k, value);
      add<K, WithSlopes>(nodes, k, value, field);
    }
  }

  template <int K>
  ASSAY_INLINE void add_affine(const Nodes& nodes, std::size_t k, NodePacks<K, Dim> v, double* field) const {
    constexpr int S = GridField<K>::stride;
    decltype(auto) w = derived().weights(nodes.begin + k);
    const Cells& cells = nodes.cells[k];
    double share[corners][corners], lowest[Dim][corners];  // [n][c]: w_c N_n(x_c)
    Pack<corners> weight, part, from_middle[Dim];
    load<corners>(weight, w.value.data());
    for (std::size_t n = 0; n < corners; ++n) {
      load<corners>(part, cells.share[n].data());
      store<corners>(share[n], weight * part);
    }
    find_distances(w, nodes.begin + k, from_middle);
    for (std::size_t d = 0; d < Dim; ++d) store<corners>(lowest[d], from_middle[d] - cells.fraction[d]);
    for (std::size_t d = 0; d < Dim; ++d) v.other[d] = places_.spacing() * v.other[d];  // by one cell
    ASSAY_UNROLLED
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<S> at_node[corners];
      at_node[0] = v.value;
      for (std::size_t d = 0; d < Dim; ++d) at_node[0] += lowest[d][c] * v.other[d];
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t n = 0; n < std::size_t{1} << d; ++n) at_node[n + (1 << d)] = at_node[n] + v.other[d];
      }
      double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
      for (std::size_t n = 0; n < corners; ++n) {
        assay::mpm::add<S>(places_.template node_of<S>(lower, n), share[n][c] * at_node[n]);
      }
    }
  }

  template <int K>
  ASSAY_INLINE void add_all_affine(const Nodes& nodes, std::size_t n, const Given<K, Dim>& given, double* field) const {
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<K, Dim> value;
      given.template get<true>(k, value);
      add_affine<K>(nodes, k, value, field);
    }
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void sum(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found) const {
    sum_visiting<K, WithSlopes>(nodes, k, field, found, [](std::size_t, const auto&) {});
  }

  /// visit(c, sum_i N_i(x_c) f_i) for each corner, too.
  template <int K, bool WithSlopes, class Visit>
  ASSAY_INLINE void sum_visiting(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found,
                                 const Visit& visit) const {
    decltype(auto) w = derived().weights(nodes.begin + k);
    found = {};
    ASSAY_UNROLLED
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<GridField<K>::stride> corner, upper[Dim];
      sum_by_sides<K>(nodes.cells[k], c, field, corner, upper);
      add_corner<WithSlopes>(w, c, corner, found);
      visit(c, corner);
    }
  }

  /// As that, and the moment sum_i w_i f_i (x) r_i of the first Dim components.
  template <int K, bool WithSlopes, class Visit>
  ASSAY_INLINE Mat<Dim> sum_and_moment(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found,
                                       const Visit& visit) const {
    constexpr int S = GridField<K>::stride;
    decltype(auto) w = derived().weights(nodes.begin + k);
    const Cells& cells = nodes.cells[k];
    Pack<corners> from_middle[Dim], weight;
    double lowest[Dim][corners];  // distance of the lowest node, times the weight
    load<corners>(weight, w.value.data());
    find_distances(w, nodes.begin + k, from_middle);
    for (std::size_t d = 0; d < Dim; ++d) store<corners>(lowest[d], weight * (from_middle[d] - cells.fraction[d]));
    Pack<S> moment[Dim] = {};
    found = {};
    ASSAY_UNROLLED
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<S> corner, upper[Dim];
      sum_by_sides<K>(cells, c, field, corner, upper);
      add_corner<WithSlopes>(w, c, corner, found);
      // sum_n N_n (x_n - x_c) = 0: a corner adds its value times its own distance, and what its nodes differ.
      for (std::size_t d = 0; d < Dim; ++d) moment[d] += lowest[d][c] * corner + w.value[c] * upper[d];
      visit(c, corner);
    }
    Mat<Dim> B;
    for (std::size_t c = 0; c < Dim * Dim; ++c) B[c] = places_.spacing() * moment[c % Dim][c / Dim];
    return B;
  }

  template <int K, int G>
  ASSAY_INLINE void sum_all(const Nodes& nodes, std::size_t n, const double* field, Taken<K, G, Dim>& taken) const {
    for (std::size_t k = 0; k < n; ++k) {
      NodePacks<K, Dim> found;
      sum<K, (G > 0)>(nodes, k, field, found);
      taken.set(k, found);
    }
  }

  template <int K>
  ASSAY_INLINE Mat<Dim> moment(const Nodes& nodes, std::size_t k, const double* field) const {
    NodePacks<K, Dim> found;
    return sum_and_moment<K, false>(nodes, k, field, found, [](std::size_t, const auto&) {});
  }

  ASSAY_INLINE Mat<Dim> spread(const Nodes& nodes, std::size_t k) const {
    decltype(auto) w = derived().weights(nodes.begin + k);
    const double square = places_.spacing() * places_.spacing();
    Pack<corners> from_middle[Dim], weight;
    load<corners>(weight, w.value.data());
    find_distances(w, nodes.begin + k, from_middle);
    Mat<Dim> D;
    for (std::size_t i = 0; i < Dim; ++i) {
      const Pack<corners> f = nodes.cells[k].fraction[i];
      for (std::size_t j = 0; j <= i; ++j) {
        Pack<corners> product = from_middle[i] * from_middle[j];
        if (i == j) product += f * (1 - f);
        D[i * Dim + j] = D[j * Dim + i] = square * sum_of<corners>(weight * product);
      }
    }
    return D;
  }

  ASSAY_INLINE void reach(std::size_t begin, std::size_t end, NodeBox<Dim>& nodes) const {
    places_.reach(begin, end, nodes);
  }

 protected:
  using Cells = CornerCells<Dim>;
  static constexpr std::size_t bytes_of_places = CornerPlaces<Dim>::bytes;

  CornerBasis(const GridGeometry<Dim>& grid, std::size_t particles) : places_(grid, particles) {}

  CornerPlaces<Dim> places_;

 private:
  ASSAY_INLINE const Derived& derived() const { return static_cast<const Derived&>(*this); }

  /// Of the corners from sum_c w_c x_c, by which no momentum drifts [h].
  ASSAY_INLINE void find_distances(const CornerWeights<Dim>& w, std::size_t p, Pack<corners>* distance) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      const Pack<corners> along = places_.along(p, d);
      Pack<corners> weight;
      load<corners>(weight, w.value.data());
      distance[d] = along - sum_of<corners>(weight * along);
    }
  }

  template <bool WithSlopes, int K>
  ASSAY_INLINE static void add_corner(const CornerWeights<Dim>& w, std::size_t c,
                                      const Pack<GridField<K>::stride>& corner, NodePacks<K, Dim>& found) {
    found.value += w.value[c] * corner;
    for (std::size_t d = 0; WithSlopes && d < Dim; ++d) found.other[d] += w.gradient[d][c] * corner;
  }

  /// At a corner; upper[d]: of the nodes on the upper side of direction d alone.
  template <int K>
  ASSAY_INLINE void sum_by_sides(const Cells& cells, std::size_t c, const double* field,
                                 Pack<GridField<K>::stride>& sum, Pack<GridField<K>::stride>* upper) const {
    constexpr int S = GridField<K>::stride;
    const double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
    sum = Pack<S>{};
    for (std::size_t d = 0; d < Dim; ++d) upper[d] = Pack<S>{};
    for (std::size_t n = 0; n < corners; ++n) {
      Pack<S> part;
      load<S>(part, places_.template node_of<S>(lower, n));
      part *= cells.share[n][c];
      sum += part;
      for (std::size_t d = 0; d < Dim; ++d) {
        if (n >> d & 1) upper[d] += part;
      }
    }
  }
};

}  // namespace assay::mpm
