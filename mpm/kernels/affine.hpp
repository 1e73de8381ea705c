// SPDX-License-Identifier: BSD-3-Clause
// The velocity around a particle: who carries it, and the algebra of it.
#pragma once

#include <cmath>

#include "mpm/basis/basis.hpp"
#include "mpm/data/columns.hpp"
#include "mpm/setup/method.hpp"

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
  return !method.is_total() && method.affine == Affine::gradient && traits_of<2>(method.basis).smooth;
}

template <int Dim>
ASSAY_INLINE Mat<Dim> product(const Mat<Dim>& A, const Mat<Dim>& B) {
  Mat<Dim> C{};
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t k = 0; k < Dim; ++k) {
      for (std::size_t j = 0; j < Dim; ++j) C[i * Dim + j] += A[i * Dim + k] * B[k * Dim + j];
    }
  }
  return C;
}

template <int Dim>
ASSAY_INLINE Mat<Dim> inverse(const Mat<Dim>& A) {
  const Mat<Dim> T = inverse_transpose<Dim>(A, determinant<Dim>(A));
  Mat<Dim> found;
  for (std::size_t i = 0; i < Dim; ++i) {
    for (std::size_t j = 0; j < Dim; ++j) found[i * Dim + j] = T[j * Dim + i];
  }
  return found;
}

template <int Dim>
double length_of(const Vec<Dim>& v) {
  if constexpr (Dim == 2) return std::hypot(v[0], v[1]);
  if constexpr (Dim == 3) return std::hypot(v[0], v[1], v[2]);
}

}  // namespace assay::mpm
