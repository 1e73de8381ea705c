// SPDX-License-Identifier: BSD-3-Clause
// Orders of components of foreign interfaces, and the factors of their shear components.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "harness/numeric/tensor.hpp"

namespace assay::adapters {

using Pair = std::array<int, 2>;

/// 11, 22, 33, 12, 13, 23: UMAT, MFront, and the state of our own ABI.
inline constexpr std::array<Pair, 6> standard_order{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
/// 11, 22, 33, 12, 23, 31: VUMAT.
inline constexpr std::array<Pair, 6> explicit_order{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
/// 11, 22, 33, 12, 23, 31, 21, 32, 13: VUMAT's deformation gradient.
inline constexpr std::array<Pair, 9> explicit_tensor_order{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}, {1, 0}, {2, 1}, {0, 2}}};
/// 11, 22, 33, 12, 21, 13, 31, 23, 32: MFront's tensors.
inline constexpr std::array<Pair, 9> mfront_tensor_order{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 0}, {0, 2}, {2, 0}, {1, 2}, {2, 1}}};

/// What a shear component is multiplied with.
inline constexpr double plain_shear = 1, engineering_shear = 2, mfront_shear = std::numbers::sqrt2;

/// Six components of a symmetric tensor, `stride` apart.
inline void write_symmetric(const Tensor& A, const std::array<Pair, 6>& order, double shear, double* out,
                            std::size_t stride = 1) {
  for (std::size_t k = 0; k < 6; ++k) out[k * stride] = (k < 3 ? 1 : shear) * A(order[k][0], order[k][1]);
}

inline Tensor read_symmetric(const double* in, const std::array<Pair, 6>& order, double shear, std::size_t stride = 1) {
  Tensor A;
  for (std::size_t k = 0; k < 6; ++k) {
    const double value = in[k * stride] / (k < 3 ? 1 : shear);
    A(order[k][0], order[k][1]) = A(order[k][1], order[k][0]) = value;
  }
  return A;
}

/// Nine components of a tensor, `stride` apart.
inline void write_tensor(const Tensor& A, const std::array<Pair, 9>& order, double* out, std::size_t stride = 1) {
  for (std::size_t k = 0; k < 9; ++k) out[k * stride] = A(order[k][0], order[k][1]);
}

inline Tensor read_tensor(const double* in, const std::array<Pair, 9>& order, std::size_t stride = 1) {
  Tensor A;
  for (std::size_t k = 0; k < 9; ++k) A(order[k][0], order[k][1]) = in[k * stride];
  return A;
}

}  // namespace assay::adapters
