// SPDX-License-Identifier: BSD-3-Clause
// Tensors of the material border: always three-dimensional, SI units.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <span>
#include <vector>

namespace assay {

using Vector3 = Eigen::Vector3d;
using Tensor = Eigen::Matrix3d;

/// Of the components 11, 22, 33, 12, 13, 23.
inline Tensor symmetric_tensor(const std::array<double, 6>& s) {
  Tensor A;
  A << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return A;
}

/// Component of a tensor by the row-major index 0..8 of the ABI (11,12,13,21,22,23,31,32,33).
inline double component(const Tensor& tensor, int index) { return tensor(index / 3, index % 3); }
inline double& component(Tensor& tensor, int index) { return tensor(index / 3, index % 3); }

/// The nine components as the ABI has them, and back.
inline std::array<double, 9> nine_of(const Tensor& A) {
  std::array<double, 9> nine;
  for (int c = 0; c < 9; ++c) nine[static_cast<std::size_t>(c)] = component(A, c);
  return nine;
}
inline Tensor tensor_of(const double* nine) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(nine);
}

/// What point p of n has in an array of the ABI, which is component-major.
inline void put_point(std::span<const double> values, double* array, std::size_t n, std::size_t p) {
  for (std::size_t c = 0; c < values.size(); ++c) array[c * n + p] = values[c];
}
inline std::vector<double> point_of(const double* array, std::size_t n, std::size_t p, std::size_t components) {
  std::vector<double> values(components);
  for (std::size_t c = 0; c < components; ++c) values[c] = array[c * n + p];
  return values;
}
inline void put_tensor(const Tensor& A, double* array, std::size_t n, std::size_t p) {
  put_point(nine_of(A), array, n, p);
}
inline Tensor tensor_at(const double* array, std::size_t n, std::size_t p) {
  Tensor A;
  for (int c = 0; c < 9; ++c) component(A, c) = array[static_cast<std::size_t>(c) * n + p];
  return A;
}

/// Whether the index 0..8 is one of 11, 12, 21, 22 and 33, which a motion in the plane 12 has.
inline bool is_in_plane(int index) { return index == 8 || (index / 3 != 2 && index % 3 != 2); }

/// First Piola-Kirchhoff stress P = J sigma F^-T [Pa]; first index spatial, second referential.
inline Tensor first_piola_kirchhoff(const Tensor& cauchy, const Tensor& deformation_gradient) {
  return deformation_gradient.determinant() * cauchy * deformation_gradient.inverse().transpose();
}

/// Cauchy stress sigma = P F^T / J [Pa].
inline Tensor cauchy_stress(const Tensor& first_piola_kirchhoff, const Tensor& deformation_gradient) {
  return first_piola_kirchhoff * deformation_gradient.transpose() / deformation_gradient.determinant();
}

/// Rotation by `angle` [rad] about E_z: the matrices Q (4), q (16) and r (17).
inline Tensor rotation_about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Tensor rotation;
  rotation << c, -s, 0, s, c, 0, 0, 0, 1;
  return rotation;
}

}  // namespace assay
