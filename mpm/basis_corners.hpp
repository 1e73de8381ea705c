// SPDX-License-Identifier: BSD-3-Clause
// Bases that weigh the grid's multilinear functions N_i at the corners x_c of a particle's domain:
//   phi_ip = sum_c w_c N_i(x_c),   grad phi_ip = sum_c N_i(x_c) g_c.
#pragma once

#include "mpm/corners.hpp"
#include "mpm/node_packs.hpp"

namespace assay::mpm {

/// w_c and g_c: component d of g_c stands in gradient[d][c] [1/m].
template <int Dim>
struct CornerWeights {
  std::array<double, 1 << Dim> value;
  std::array<std::array<double, 1 << Dim>, Dim> gradient;
};

/// Derived gives weights(p): CornerWeights.
template <class Derived, int Dim>
class CornerBasis {
 public:
  static constexpr int corners = 1 << Dim;
  static constexpr int nodes_across = 0;  ///< as its domain is large

  /// Nothing is made in advance.
  struct Nodes {
    std::size_t begin = 0;
  };
  ASSAY_INLINE void expand(std::size_t begin, std::size_t, Nodes& nodes) const { nodes.begin = begin; }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void add(const Nodes& nodes, std::size_t k, const NodePacks<K, Dim>& v, double* field) const {
    constexpr int S = GridField<K>::stride;
    decltype(auto) w = derived().weights(nodes.begin + k);
    Cells cells;
    find_cells(nodes.begin + k, cells);
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<S> value = w.value[c] * v.value;
      if constexpr (WithSlopes) {
        for (std::size_t d = 0; d < Dim; ++d) value += w.gradient[d][c] * v.other[d];
      }
      double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
      for (std::size_t n = 0; n < corners; ++n) assay::mpm::add<S>(node_of<S>(lower, n), cells.share[n][c] * value);
    }
  }

  template <int K, bool WithSlopes>
  ASSAY_INLINE void sum(const Nodes& nodes, std::size_t k, const double* field, NodePacks<K, Dim>& found) const {
    decltype(auto) w = derived().weights(nodes.begin + k);
    Cells cells;
    find_cells(nodes.begin + k, cells);
    found = {};
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<GridField<K>::stride> corner;
      sum_at_corner<K>(cells, c, field, corner);
      found.value += w.value[c] * corner;
      if constexpr (WithSlopes) {
        for (std::size_t d = 0; d < Dim; ++d) found.other[d] += w.gradient[d][c] * corner;
      }
    }
  }

  /// Particles begin to end - 1 reach nodes from first to last - 1 in the order of the grid.
  ASSAY_INLINE void reach(std::size_t begin, std::size_t end, std::int32_t& first, std::int32_t& last) const {
    first = last = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      Extremes<corners> of_corners(last_cell_[d]);
      for (std::size_t p = begin; p < end; ++p) {
        for (std::size_t c = 0; c < corners; ++c) of_corners.include(c, along_[p][d][c]);
      }
      first += static_cast<std::int32_t>(of_corners.lowest()) * stride_[d];
      last += (static_cast<std::int32_t>(of_corners.highest()) + 1) * stride_[d];
    }
    ++last;
  }

  template <int K, int G>
  ASSAY_INLINE void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
                            double* field) const {
    NodePacks<K, Dim> v;
    v.template set<G>(A, B);
    add<K, (G > 0)>(Nodes{p}, 0, v, field);
  }

  template <int K>
  ASSAY_INLINE void scatter_affine(std::size_t p, const std::array<double, K>& A, const Mat<Dim>& C,
                                   double* field) const {
    NodePacks<K, Dim> v;
    v.template set<Dim>(A, C);
    add_affine<K>(Nodes{p}, 0, v, field);
  }

  ASSAY_INLINE void slopes_to_moments(std::size_t, Nodes&) const {}

  template <int K>
  ASSAY_INLINE void add_affine(const Nodes& nodes, std::size_t k, NodePacks<K, Dim> v, double* field) const {
    constexpr int S = GridField<K>::stride;
    decltype(auto) w = derived().weights(nodes.begin + k);
    Cells cells;
    find_cells(nodes.begin + k, cells);
    Pack<corners> from_middle[Dim];
    find_distances(w, cells, from_middle);
    for (std::size_t d = 0; d < Dim; ++d) v.other[d] = spacing_ * v.other[d];  // by one cell
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<S> at_node[corners];
      at_node[0] = v.value;
      for (std::size_t d = 0; d < Dim; ++d) at_node[0] += (from_middle[d][c] - cells.fraction[d][c]) * v.other[d];
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t n = 0; n < std::size_t{1} << d; ++n) at_node[n + (1 << d)] = at_node[n] + v.other[d];
      }
      double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
      for (std::size_t n = 0; n < corners; ++n) {
        assay::mpm::add<S>(node_of<S>(lower, n), (w.value[c] * cells.share[n][c]) * at_node[n]);
      }
    }
  }

  template <int K, int G>
  ASSAY_INLINE void gather(std::size_t p, const double* field, std::array<double, K>& value,
                           std::array<double, G * Dim>& gradient) const {
    NodePacks<K, Dim> found;
    sum<K, (G > 0)>(Nodes{p}, 0, field, found);
    found.template get<G>(value, gradient);
  }

  /// sum_i N_i(x_c) f_i at each corner.
  template <int K>
  ASSAY_INLINE void at_corners(std::size_t p, const double* field,
                               std::array<std::array<double, K>, corners>& values) const {
    Cells cells;
    find_cells(p, cells);
    for (std::size_t c = 0; c < corners; ++c) {
      Pack<GridField<K>::stride> corner;
      sum_at_corner<K>(cells, c, field, corner);
      for (std::size_t k = 0; k < K; ++k) values[c][k] = corner[k];
    }
  }

  template <int K>
  ASSAY_INLINE Mat<Dim> first_moment(std::size_t p, const double* field) const {
    decltype(auto) w = derived().weights(p);
    Cells cells;
    find_cells(p, cells);
    Pack<corners> from_middle[Dim];
    find_distances(w, cells, from_middle);
    return first_moment_of<K>(w, cells, from_middle, field);
  }

  ASSAY_INLINE Mat<Dim> second_moment(std::size_t p) const {
    decltype(auto) w = derived().weights(p);
    Cells cells;
    find_cells(p, cells);
    Pack<corners> from_middle[Dim];
    find_distances(w, cells, from_middle);
    return second_moment_of(w, cells, from_middle);
  }

  template <int K>
  ASSAY_INLINE void moments(std::size_t p, const double* field, Mat<Dim>& first, Mat<Dim>& second) const {
    decltype(auto) w = derived().weights(p);
    Cells cells;
    find_cells(p, cells);
    Pack<corners> from_middle[Dim];
    find_distances(w, cells, from_middle);
    first = first_moment_of<K>(w, cells, from_middle, field);
    second = second_moment_of(w, cells, from_middle);
  }

 protected:
  /// Cell coordinates of the corners: [d][c].
  using Along = std::array<std::array<double, corners>, Dim>;
  static constexpr std::size_t bytes_of_places = sizeof(Along);

  CornerBasis(const GridGeometry<Dim>& grid, std::size_t particles)
      : spacing_(grid.spacing), inverse_spacing_(1 / grid.spacing), along_(particles) {
    std::int32_t stride = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      stride_[d] = stride;
      for (std::size_t n = 0; n < corners; ++n) offsets_[n] += (n >> d & 1) ? stride : 0;
      first_[d] = grid.first[d];
      last_cell_[d] = grid.count[d] - 1;
      stride *= grid.count[d];
    }
  }

  /// x[d]: of the corners [m]. False outside the grid or where one is no number.
  ASSAY_INLINE bool place_corners(std::size_t p, const Pack<corners>* x) {
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      auto& along = along_[p][d];
      store<corners>(along.data(), x[d] * inverse_spacing_ - first_[d]);
      for (const double at : along) inside &= at >= 0 && at < last_cell_[d];
    }
    if (!inside) along_[p] = {};
    return inside;
  }

 private:
  /// Where the corners lie, and share[n][c] = N_n(x_c) of node n of its cell.
  struct Cells {
    Pack<corners> lower[Dim], fraction[Dim];
    std::array<std::array<double, corners>, corners> share;
    std::array<std::int32_t, corners> node;
  };

  ASSAY_INLINE const Derived& derived() const { return static_cast<const Derived&>(*this); }

  /// Node n of the cell of a corner, from its lower node on; S numbers a node.
  template <int S, class Number>
  ASSAY_INLINE Number* node_of(Number* lower, std::size_t n) const {
    return lower + offsets_[n] * S;
  }

  ASSAY_INLINE void find_cells(std::size_t p, Cells& cells) const {
    cells.node.fill(0);
    Pack<corners> share[corners];
    share[0] = 1 - Pack<corners>{};
    for (std::size_t d = 0; d < Dim; ++d) {
      Pack<corners> along;
      std::array<std::int32_t, corners> cell;
      load<corners>(along, along_[p][d].data());
      truncate<corners>(along, cell, cells.lower[d]);
      const Pack<corners> f = along - cells.lower[d], g = 1 - f;
      cells.fraction[d] = f;
      for (std::size_t c = 0; c < corners; ++c) cells.node[c] += cell[c] * stride_[d];
      for (std::size_t n = 0; n < std::size_t{1} << d; ++n) {
        share[n + (1 << d)] = share[n] * f;
        share[n] = share[n] * g;
      }
    }
    for (std::size_t n = 0; n < corners; ++n) store<corners>(cells.share[n].data(), share[n]);
  }

  /// Of the corners from sum_c w_c x_c, by which no momentum drifts [h].
  ASSAY_INLINE static void find_distances(const CornerWeights<Dim>& w, const Cells& cells, Pack<corners>* distance) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const Pack<corners> along = cells.lower[d] + cells.fraction[d];
      double middle = 0;
      for (std::size_t c = 0; c < corners; ++c) middle += w.value[c] * along[c];
      distance[d] = along - middle;
    }
  }

  /// The nodes of a corner's cell lie symmetrically enough: sum_n N_n (x_n - x_c) = 0, so each corner adds its own
  /// value times its own distance, and what its nodes differ.
  template <int K>
  ASSAY_INLINE Mat<Dim> first_moment_of(const CornerWeights<Dim>& w, const Cells& cells,
                                        const Pack<corners>* from_middle, const double* field) const {
    constexpr int S = GridField<K>::stride;
    Pack<S> moment[Dim] = {};
    for (std::size_t c = 0; c < corners; ++c) {
      const double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
      Pack<S> corner{}, upper[Dim] = {};
      for (std::size_t n = 0; n < corners; ++n) {
        Pack<S> part;
        load<S>(part, node_of<S>(lower, n));
        part *= cells.share[n][c];
        corner += part;
        for (std::size_t d = 0; d < Dim; ++d) {
          if (n >> d & 1) upper[d] += part;
        }
      }
      for (std::size_t d = 0; d < Dim; ++d) {
        moment[d] += w.value[c] * ((from_middle[d][c] - cells.fraction[d][c]) * corner + upper[d]);
      }
    }
    Mat<Dim> found;
    for (std::size_t k = 0; k < Dim * Dim; ++k) found[k] = spacing_ * moment[k % Dim][k / Dim];
    return found;
  }

  ASSAY_INLINE Mat<Dim> second_moment_of(const CornerWeights<Dim>& w, const Cells& cells,
                                         const Pack<corners>* from_middle) const {
    Mat<Dim> D{};
    for (std::size_t c = 0; c < corners; ++c) {
      for (std::size_t i = 0; i < Dim; ++i) {
        for (std::size_t j = 0; j < Dim; ++j) D[i * Dim + j] += w.value[c] * from_middle[i][c] * from_middle[j][c];
        D[i * Dim + i] += w.value[c] * cells.fraction[i][c] * (1 - cells.fraction[i][c]);
      }
    }
    for (double& d : D) d *= spacing_ * spacing_;
    return D;
  }

  template <int K>
  ASSAY_INLINE void sum_at_corner(const Cells& cells, std::size_t c, const double* field,
                                  Pack<GridField<K>::stride>& sum) const {
    constexpr int S = GridField<K>::stride;
    const double* lower = field + std::ptrdiff_t{cells.node[c]} * S;
    sum = Pack<S>{};
    for (std::size_t n = 0; n < corners; ++n) {
      Pack<S> part;
      load<S>(part, node_of<S>(lower, n));
      sum += cells.share[n][c] * part;
    }
  }

  double spacing_, inverse_spacing_;
  Vec<Dim> first_, last_cell_;
  std::array<std::int32_t, Dim> stride_{};
  std::array<std::ptrdiff_t, corners> offsets_{};
  std::vector<Along> along_;
};

}  // namespace assay::mpm
