// SPDX-License-Identifier: BSD-3-Clause
// The velocity around a particle: sums over nodes i with r_i = x_i - sum_j w_j x_j.
#pragma once

#include "mpm/basis.hpp"
#include "mpm/columns.hpp"
#include "mpm/method.hpp"

namespace assay::mpm {

/// Where particles_to_grid finds it. In the total formulation the step's dF/dt is that gradient already.
inline Column affine_column(const Method& method) {
  const bool known = method.is_total() && method.update == Update::usl && method.affine == Affine::gradient;
  return known ? Column::velocity_gradient : Column::affine;
}

/// Whether C is fitted to the velocity around the particle, B D^-1. Of a linear field that is its gradient, as grad phi
/// gives it; of a rough one it is smoother: short waves that C = sum v_i (x) grad phi_ip brings back grow in the
/// updated formulation. In the total one they do not, and where functions are linear D vanishes at their nodes.
inline bool fits_gradient(const Method& method) {
  return !method.is_total() && method.affine == Affine::gradient && method.basis != Basis::linear;
}

template <int Dim>
Mat<Dim> product(const Mat<Dim>& A, const Mat<Dim>& B) {
  Mat<Dim> C{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      for (std::size_t j = 0; j < Dim; ++j) C[i * Dim + j] += A[i * Dim + k] * B[k * Dim + j];
    }
  }
  return C;
}

template <int Dim>
Mat<Dim> inverse(const Mat<Dim>& A) {
  const Mat<Dim> T = inverse_transpose<Dim>(A, determinant<Dim>(A));
  Mat<Dim> found;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) found[i * Dim + j] = T[j * Dim + i];
  }
  return found;
}

/// Adds w_i (A + (0, C r_i)) to each node: C acts on the last Dim of the K components.
template <class B, std::size_t K, std::size_t N>
void scatter_affine(const B& basis, std::size_t p, const std::array<double, K>& A, const std::array<double, N>& C,
                    GridField<static_cast<int>(K)>& field) {
  constexpr std::size_t Dim = N == 4 ? 2 : 3;
  basis.each_node(p, [&](std::size_t i, double w, const Vec<Dim>& r) {
    double* node = field.node(i);
    for (std::size_t k = 0; k < K - Dim; ++k) node[k] += w * A[k];
    for (std::size_t d = 0; d < Dim; ++d) {
      double value = A[K - Dim + d];
      for (std::size_t j = 0; j < Dim; ++j) value += C[d * Dim + j] * r[j];
      node[K - Dim + d] += w * value;
    }
  });
}

/// D = sum_i w_i r_i (x) r_i [m^2].
template <int Dim, class B>
Mat<Dim> second_moment(const B& basis, std::size_t p) {
  Mat<Dim> D{};
  basis.each_node(p, [&](std::size_t, double w, const Vec<Dim>& r) {
    for (std::size_t c = 0; c < Dim * Dim; ++c) D[c] += w * r[c / Dim] * r[c % Dim];
  });
  return D;
}

/// L = sum_i v_i (x) grad w_i [1/s] of the velocities of a field of velocity and acceleration.
template <int Dim, class B>
Mat<Dim> velocity_gradient(const B& basis, std::size_t p, const GridField<2 * Dim>& field) {
  std::array<double, 2 * Dim> motion;
  Mat<Dim> gradient;
  basis.template gather<2 * Dim, Dim>(p, field, motion, gradient);
  return gradient;
}

/// B = sum_i w_i v_i (x) r_i [m^2/s] of the first Dim components of a field.
template <int Dim, class B, int K>
Mat<Dim> first_moment(const B& basis, std::size_t p, const GridField<K>& field) {
  Mat<Dim> moment{};
  basis.each_node(p, [&](std::size_t i, double w, const Vec<Dim>& r) {
    const double* v = field.node(i);
    for (std::size_t c = 0; c < Dim * Dim; ++c) moment[c] += w * v[c / Dim] * r[c % Dim];
  });
  return moment;
}

}  // namespace assay::mpm
