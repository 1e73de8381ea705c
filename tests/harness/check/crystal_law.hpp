// SPDX-License-Identifier: BSD-3-Clause
// The stiffness of a crystal in axes of its own, turned by Bond's matrices as authors of models write them: engineering
// shears, components 11, 22, 33, 12, 13, 23. A number plants one mistake.
#pragma once

#include <Eigen/Dense>
#include <numbers>

#include "harness/numeric/tensor.hpp"

namespace assay::check_tests {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

enum BondDefect : int {
  bond_right,
  bond_wrong_sign,          ///< of one coefficient of the matrix for strains
  bond_of_another_place,    ///< two coefficients in each other's place
  bond_of_stress,           ///< for the strain: its shears take no factor
  bond_of_stress_for_both,  ///< C' = M C M^-1, as if the stiffness took tensor shears
  bond_turned_on,           ///< the stress turned as the strain was, not back
  bond_transposed,          ///< in the second product alone
  bond_defects
};

/// Rows: the axes of the crystal in space (Bunge's angles [rad]).
inline Tensor crystal_axes(double phi1, double Phi, double phi2) {
  Tensor tilt;
  tilt << 1, 0, 0, 0, std::cos(Phi), std::sin(Phi), 0, -std::sin(Phi), std::cos(Phi);
  return rotation_about_z(-phi2) * tilt * rotation_about_z(-phi1);
}

inline constexpr int bond_places[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

/// M with sigma' = M sigma, T'_ij = R_ik R_jl T_kl.
inline Matrix6 bond_for_stress(const Tensor& R) {
  Matrix6 M;
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const int i = bond_places[a][0], j = bond_places[a][1], k = bond_places[b][0], l = bond_places[b][1];
      M(a, b) = k == l ? R(i, k) * R(j, k) : R(i, k) * R(j, l) + R(i, l) * R(j, k);
    }
  }
  return M;
}

/// N with e' = N e of engineering shears.
inline Matrix6 bond_for_strain(const Tensor& R) {
  const Vector6 shears = (Vector6() << 1, 1, 1, 2, 2, 2).finished();
  return shears.asDiagonal() * bond_for_stress(R) * shears.cwiseInverse().asDiagonal();
}

/// In axes of space, of C in those of the crystal: N^T C N.
inline Matrix6 turned_stiffness(const Matrix6& C, const Tensor& R, int defect) {
  Matrix6 N = bond_for_strain(R);
  if (defect == bond_wrong_sign) N(3, 4) *= -1;
  if (defect == bond_of_another_place) std::swap(N(3, 4), N(3, 5));
  const Matrix6 M = bond_for_stress(R), Nt = N.transpose();
  switch (defect) {
    case bond_of_stress:
      return Nt * C * M;
    case bond_of_stress_for_both:
      return M.transpose() * C * M;
    case bond_turned_on:
      return M * C * N;
    case bond_transposed:
      return Nt * C * bond_for_strain(R.transpose());
    default:
      return Nt * C * N;
  }
}

/// Engineering shears.
inline Vector6 voigt_strain(const Tensor& e) {
  return (Vector6() << e(0, 0), e(1, 1), e(2, 2), 2 * e(0, 1), 2 * e(0, 2), 2 * e(1, 2)).finished();
}

inline Tensor tensor_of_stress(const Vector6& s) {
  return (Tensor() << s(0), s(3), s(4), s(3), s(1), s(5), s(4), s(5), s(2)).finished();
}

/// Orthotropic, and with C14 (2311) trigonal where the rest is.
struct CrystalModuli {
  double C11, C22, C33, C12, C13, C23, C1212, C1313, C2323, C1123 = 0;
  double C21_over_C12 = 1;

  Matrix6 matrix() const {
    Matrix6 C = Matrix6::Zero();
    C(0, 0) = C11, C(1, 1) = C22, C(2, 2) = C33;
    C(0, 1) = C12, C(1, 0) = C21_over_C12 * C12;
    C(0, 2) = C(2, 0) = C13, C(1, 2) = C(2, 1) = C23;
    C(3, 3) = C1212, C(4, 4) = C1313, C(5, 5) = C2323;
    C(0, 5) = C(5, 0) = C1123, C(1, 5) = C(5, 1) = -C1123;
    C(3, 4) = C(4, 3) = C1123;
    return C;
  }
};

inline CrystalModuli cubic_moduli(double C11, double C12, double C44) {
  return {C11, C11, C11, C12, C12, C12, C44, C44, C44};
}

/// About the third axis.
inline CrystalModuli transversely_isotropic_moduli(double C11, double C33, double C12, double C13, double C44) {
  return {C11, C11, C33, C12, C13, C13, (C11 - C12) / 2, C44, C44};
}

}  // namespace assay::check_tests
