// SPDX-License-Identifier: BSD-3-Clause
// Sums over the nodes of particles whose weights are products of one-dimensional ones on Width neighbouring nodes.
#pragma once

#include "mpm/basis/basis.hpp"

namespace assay::mpm {

/// Weights in each direction of neighbouring particles, and what goes with them: their slopes [1/m] or their moments
/// w r [m].
template <int Dim, int Width>
struct Lines {
  double values[Dim][Width][particles_at_once], others[Dim][Width][particles_at_once];
  std::int32_t node[particles_at_once];  ///< the first of each particle

  ASSAY_INLINE double value(std::size_t k, std::size_t d, std::size_t i) const { return values[d][i][k]; }
  ASSAY_INLINE double other(std::size_t k, std::size_t d, std::size_t i) const { return others[d][i][k]; }
};

/// Nodes from one to the next in each direction.
template <int Dim>
struct NodeSteps {
  std::size_t of[Dim];
  ASSAY_INLINE std::size_t operator[](std::size_t d) const { return of[d]; }
};

/// What a particle gives to its nodes in row j of plane `plane`.
template <int K, int Dim>
struct RowShare {
  Pack<GridField<K>::stride> along{}, across{};  ///< times the weight and the other in the first direction

  template <bool WithOther, int Width>
  ASSAY_INLINE void set(const Lines<Dim, Width>& w, std::size_t k, std::size_t j, const NodePacks<K, Dim>& v) {
    along = w.value(k, 1, j) * v.value;
    if constexpr (WithOther) {
      along += w.other(k, 1, j) * v.other[1];
      across = w.value(k, 1, j) * v.other[0];
    }
  }

  template <bool WithOther, int Width>
  ASSAY_INLINE void add(const Lines<Dim, Width>& w, std::size_t k, std::size_t i,
                        Pack<GridField<K>::stride>& node) const {
    Pack<GridField<K>::stride> change = w.value(k, 0, i) * along;
    if constexpr (WithOther) change += w.other(k, 0, i) * across;
    node += change;
  }
};

/// Particle k alone.
template <int K, bool WithOther, int Dim, int Width>
ASSAY_INLINE void add_to_nodes(const Lines<Dim, Width>& w, std::size_t k, const NodePacks<K, Dim>& v,
                               const NodeSteps<Dim>& step, double* field) {
  constexpr int S = GridField<K>::stride;
  double* first = field + static_cast<std::size_t>(w.node[k]) * S;
  for (std::size_t plane = 0; plane < (Dim == 2 ? 1 : Width); ++plane) {
    NodePacks<K, Dim> share = v;
    if constexpr (Dim == 3) {
      share.value = w.value(k, 2, plane) * v.value;
      if constexpr (WithOther) {
        share.value += w.other(k, 2, plane) * v.other[2];
        for (int d = 0; d < 2; ++d) share.other[d] = w.value(k, 2, plane) * v.other[d];
      }
    }
    for (std::size_t j = 0; j < Width; ++j) {
      double* row = first + ((Dim == 3 ? plane * step[Dim - 1] : 0) + j * step[1]) * S;
      RowShare<K, Dim> of_row;
      of_row.template set<WithOther>(w, k, j, share);
      for (std::size_t i = 0; i < Width; ++i) {
        Pack<S> node;
        load<S>(node, row + i * S);
        of_row.template add<WithOther>(w, k, i, node);
        store<S>(row + i * S, node);
      }
    }
  }
}

/// Particles first to end - 1, which share their nodes: those stay in registers. The bits are those of one by one.
template <int K, bool WithOther, int Width, class Given>
ASSAY_INLINE void add_run(const Lines<2, Width>& w, std::size_t first, std::size_t end, const Given& given,
                          const NodeSteps<2>& step, double* field) {
  constexpr int S = GridField<K>::stride;
  double* corner = field + static_cast<std::size_t>(w.node[first]) * S;
  Pack<S> nodes[Width][Width];
  ASSAY_UNROLLED
  for (std::size_t j = 0; j < Width; ++j) {
    ASSAY_UNROLLED
    for (std::size_t i = 0; i < Width; ++i) load<S>(nodes[j][i], corner + (j * step[1] + i) * S);
  }
  for (std::size_t k = first; k < end; ++k) {
    NodePacks<K, 2> v;
    given.template get<WithOther>(k, v);
    ASSAY_UNROLLED
    for (std::size_t j = 0; j < Width; ++j) {
      RowShare<K, 2> of_row;
      of_row.template set<WithOther>(w, k, j, v);
      ASSAY_UNROLLED
      for (std::size_t i = 0; i < Width; ++i) of_row.template add<WithOther>(w, k, i, nodes[j][i]);
    }
  }
  ASSAY_UNROLLED
  for (std::size_t j = 0; j < Width; ++j) {
    ASSAY_UNROLLED
    for (std::size_t i = 0; i < Width; ++i) store<S>(corner + (j * step[1] + i) * S, nodes[j][i]);
  }
}

/// Particle k alone.
template <int K, bool WithOther, int Dim, int Width>
ASSAY_INLINE void sum_over_nodes(const Lines<Dim, Width>& w, std::size_t k, const double* field,
                                 const NodeSteps<Dim>& step, NodePacks<K, Dim>& sum) {
  constexpr int S = GridField<K>::stride;
  const double* first = field + static_cast<std::size_t>(w.node[k]) * S;
  sum = {};
  for (std::size_t p = 0; p < (Dim == 2 ? 1 : Width); ++p) {
    NodePacks<K, Dim> plane{};
    ASSAY_UNROLLED
    for (std::size_t j = 0; j < Width; ++j) {
      const double* row = first + ((Dim == 3 ? p * step[Dim - 1] : 0) + j * step[1]) * S;
      Pack<S> along{}, across{};
      ASSAY_UNROLLED
      for (std::size_t i = 0; i < Width; ++i) {
        Pack<S> node;
        load<S>(node, row + i * S);
        along += w.value(k, 0, i) * node;
        if constexpr (WithOther) across += w.other(k, 0, i) * node;
      }
      plane.value += w.value(k, 1, j) * along;
      if constexpr (WithOther) {
        plane.other[0] += w.value(k, 1, j) * across;
        plane.other[1] += w.other(k, 1, j) * along;
      }
    }
    if constexpr (Dim == 2) {
      sum = plane;
    } else {
      sum.value += w.value(k, 2, p) * plane.value;
      if constexpr (WithOther) {
        for (int d = 0; d < 2; ++d) sum.other[d] += w.value(k, 2, p) * plane.other[d];
        sum.other[2] += w.other(k, 2, p) * plane.value;
      }
    }
  }
}

/// Particles that share their nodes and are worked on side by side.
inline constexpr int run_lanes = 4;

/// Their weights; `in_row`, `of_row`: beside them what goes with them in the first direction, and themselves once more.
template <int Width>
struct RunWeights {
  Pack<2 * run_lanes> in_row[Width], of_row[Width];
  Pack<run_lanes> other_of_row[Width];

  ASSAY_INLINE RunWeights(const Lines<2, Width>& w, std::size_t first) {
    ASSAY_UNROLLED
    for (std::size_t i = 0; i < Width; ++i) {
      Pack<run_lanes> value, other;
      load<run_lanes>(value, &w.values[0][i][first]);
      load<run_lanes>(other, &w.others[0][i][first]);
      join(in_row[i], value, other);
      load<run_lanes>(value, &w.values[1][i][first]);
      join(of_row[i], value, value);
      load<run_lanes>(other_of_row[i], &w.others[1][i][first]);
    }
  }
};

/// Value and slopes of a component. The bits are those of one by one.
template <int S, int Width>
ASSAY_INLINE void sum_of_run(const RunWeights<Width>& w, const double* component, std::size_t row,
                             Pack<run_lanes>& value, Pack<run_lanes>* slope) {
  Pack<2 * run_lanes> sum{};
  slope[1] = Pack<run_lanes>{};
  ASSAY_UNROLLED
  for (std::size_t j = 0; j < Width; ++j) {
    Pack<2 * run_lanes> of_row{};
    ASSAY_UNROLLED
    for (std::size_t i = 0; i < Width; ++i) of_row += component[j * row + i * S] * w.in_row[i];
    sum += w.of_row[j] * of_row;
    Pack<run_lanes> along, across;
    split(of_row, along, across);
    slope[1] += w.other_of_row[j] * along;
  }
  split(sum, value, slope[0]);
}

/// Its value alone.
template <int S, int Width>
ASSAY_INLINE void sum_of_run(const RunWeights<Width>& w, const double* component, std::size_t row,
                             Pack<run_lanes>& value) {
  value = Pack<run_lanes>{};
  Pack<run_lanes> in_row[Width], weight, same;
  ASSAY_UNROLLED
  for (std::size_t i = 0; i < Width; ++i) split(w.in_row[i], in_row[i], same);
  ASSAY_UNROLLED
  for (std::size_t j = 0; j < Width; ++j) {
    Pack<run_lanes> of_row{};
    ASSAY_UNROLLED
    for (std::size_t i = 0; i < Width; ++i) of_row += component[j * row + i * S] * in_row[i];
    split(w.of_row[j], weight, same);
    value += weight * of_row;
  }
}

/// Particles first to first + run_lanes - 1.
template <int K, int G, int Width>
ASSAY_INLINE void sum_run(const Lines<2, Width>& w, std::size_t first, const double* field, const NodeSteps<2>& step,
                          Taken<K, G, 2>& taken) {
  constexpr int S = GridField<K>::stride;
  const double* corner = field + static_cast<std::size_t>(w.node[first]) * S;
  const RunWeights<Width> weights(w, first);
  Pack<run_lanes> value;
  ASSAY_UNROLLED
  for (std::size_t c = 0; c < G; ++c) {
    Pack<run_lanes> slope[2];
    sum_of_run<S>(weights, corner + c, step[1] * S, value, slope);
    store<run_lanes>(&taken.value[c][first], value);
    ASSAY_UNROLLED
    for (std::size_t d = 0; d < 2; ++d) store<run_lanes>(&taken.slope[d][c][first], slope[d]);
  }
  ASSAY_UNROLLED
  for (std::size_t c = G; c < K; ++c) {
    sum_of_run<S>(weights, corner + c, step[1] * S, value);
    store<run_lanes>(&taken.value[c][first], value);
  }
}

}  // namespace assay::mpm
