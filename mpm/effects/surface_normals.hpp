// SPDX-License-Identifier: BSD-3-Clause
// n ds of pieces of a surface, shared out to their ends.
#pragma once

#include "harness/numeric/gauss.hpp"
#include "harness/numeric/tensor.hpp"
#include "mpm/basis/basis.hpp"
#include "mpm/setup/setup.hpp"

namespace assay::mpm {

inline Vector3 cross_of(const Vec<3>& a, const Vec<3>& b) {
  return Vector3(a[0], a[1], a[2]).cross(Vector3(b[0], b[1], b[2]));
}

/// Whether the order of the ends goes round the normal, which points out of the body, or against it.
inline double side_of(const SurfacePiece<2>& edge) {
  const double X = edge.X[1][0] - edge.X[0][0], Y = edge.X[1][1] - edge.X[0][1];
  return Y * edge.N_dA[0] - X * edge.N_dA[1] > 0 ? 1 : -1;  // (dy, -dx) points out of the body, or in
}
inline double side_of(const SurfacePiece<3>& face) {
  Vec<3> first, second;
  for (std::size_t d = 0; d < 3; ++d) first[d] = face.X[1][d] - face.X[0][d], second[d] = face.X[2][d] - face.X[0][d];
  return cross_of(first, second).dot(Vector3(face.N_dA[0], face.N_dA[1], face.N_dA[2])) > 0 ? 1 : -1;
}

/// The shares of n ds of an edge in its ends' functions: the same.
inline std::array<Vec<2>, 2> normals_of_ends(const std::array<Vec<2>, 2>& x, double side) {
  const Vec<2> half{0.5 * side * (x[1][1] - x[0][1]), -0.5 * side * (x[1][0] - x[0][0])};
  return {half, half};
}

/// The integrals of its corners' functions times n da over a bilinear face, corners 0 and 1, 2 and 3 along its first
/// direction: of second degree along each, so that 2 x 2 Gauss points are exact. The mean of the corners would do for
/// parallelograms alone.
inline std::array<Vec<3>, 4> normals_of_ends(const std::array<Vec<3>, 4>& x, double side) {
  std::array<Vec<3>, 4> found{};
  for (const GaussPoint& u : gauss_rule<2>()) {
    for (const GaussPoint& v : gauss_rule<2>()) {
      const double a = 0.5 * (1 + u.at), b = 0.5 * (1 + v.at);
      Vec<3> first, second;
      for (std::size_t d = 0; d < 3; ++d) {
        first[d] = (1 - b) * (x[1][d] - x[0][d]) + b * (x[3][d] - x[2][d]);
        second[d] = (1 - a) * (x[2][d] - x[0][d]) + a * (x[3][d] - x[1][d]);
      }
      const Vector3 normal = 0.25 * u.weight * v.weight * side * cross_of(first, second);
      const double functions[4] = {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b};
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t d = 0; d < 3; ++d) found[k][d] += functions[k] * normal[static_cast<int>(d)];
      }
    }
  }
  return found;
}

}  // namespace assay::mpm
