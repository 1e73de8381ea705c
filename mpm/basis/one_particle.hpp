// SPDX-License-Identifier: BSD-3-Clause
// What a basis does for one particle alone, from what it does for several: for set-up and property tests.
#pragma once

#include "mpm/basis/basis.hpp"

namespace assay::mpm {

template <class Derived, int Dim>
class OneParticle {
 public:
  /// Adds w_i A + (0, B grad w_i) to each node i: A has K components, B acts on the last G.
  template <int K, int G>
  void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
               double* field) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    NodePacks<K, Dim> value;
    value.template set<G>(A, B);
    derived().template add<K, (G > 0)>(nodes, 0, value, field);
  }

  /// Adds w_i (A + (0, C r_i)): C acts on the last Dim.
  template <int K>
  void scatter_affine(std::size_t p, const std::array<double, K>& A, const Mat<Dim>& C, double* field) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    derived().slopes_to_moments(1, nodes);
    NodePacks<K, Dim> value;
    value.template set<Dim>(A, C);
    derived().template add_affine<K>(nodes, 0, value, field);
  }

  /// v = sum_i w_i f_i (K components), g = sum_i f_i (x) grad w_i of the first G of them.
  template <int K, int G>
  void gather(std::size_t p, const double* field, std::array<double, K>& value,
              std::array<double, G * Dim>& gradient) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    NodePacks<K, Dim> found;
    derived().template sum<K, (G > 0)>(nodes, 0, field, found);
    found.template get<G>(value, gradient);
  }

  /// sum_i w_i f_i (x) r_i of the first Dim components.
  template <int K>
  Mat<Dim> first_moment(std::size_t p, const double* field) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    derived().slopes_to_moments(1, nodes);
    return derived().template moment<K>(nodes, 0, field);
  }

  /// D = sum_i w_i r_i (x) r_i [m^2].
  Mat<Dim> second_moment(std::size_t p) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    return derived().spread(nodes, 0);
  }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace assay::mpm
