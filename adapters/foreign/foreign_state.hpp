// SPDX-License-Identifier: BSD-3-Clause
// The declared state of one point between a foreign array and the state of our ABI: orders of components of foreign
// interfaces, and the factors of their shear components.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>

#include "adapters/foreign/foreign_table.hpp"
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

/// In an order; a model of a plane has fewer than six.
using Components = std::span<const Pair>;
inline constexpr std::array<Pair, 3> plane_stress_order{{{0, 0}, {1, 1}, {0, 1}}};

inline void write_components(const Tensor& A, Components order, double shear, double* out) {
  for (const auto& [i, j] : order) *out++ = (i == j ? 1 : shear) * A(i, j);
}

inline Tensor read_components(const double* in, Components order, double shear) {
  Tensor A = Tensor::Zero();
  for (const auto& [i, j] : order) A(i, j) = A(j, i) = *in++ / (i == j ? 1 : shear);
  return A;
}

/// Nine components of a tensor, `stride` apart.
inline void write_tensor(const Tensor& A, const std::array<Pair, 9>& order, double* out, std::size_t stride = 1) {
  for (std::size_t k = 0; k < 9; ++k) out[k * stride] = A(order[k][0], order[k][1]);
}

/// Fortran's order of a matrix.
inline void write_column_major(const Tensor& A, double* out) { Eigen::Map<Tensor>(out, 3, 3) = A; }

/// The names of a list's elements, "a, b".
std::string listed_names(const auto& list) {
  std::string names;
  for (const auto& each : list) names += (names.empty() ? "" : ", ") + each.name;
  return names;
}

/// Whether one of them has that name.
bool has_name(const auto& list, const std::string& name) {
  return std::ranges::find(
             list, name, [](const auto& each) -> const auto& { return each.name; }) != list.end();
}

/// How an interface keeps symmetric tensors.
struct StateLayout {
  const std::array<Pair, 6>& order;
  double stress_shear, strain_shear;
};

/// Components of the declared variables of a point.
int foreign_state_size(const std::vector<ForeignVariable>& variables);
int components_of(ForeignVariable::Kind kind);
/// ASSAY_SCALAR, ...
std::int32_t abi_kind(ForeignVariable::Kind kind);

/// CMNAME, padded with blanks.
std::array<char, 80> cmname_of(const ForeignModel& model);

/// ours -> foreign and back; both contiguous, in declared order. Scalars, vectors and tensors are the same in both.
void to_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* ours,
                double* foreign);
void from_foreign(const StateLayout& layout, const std::vector<ForeignVariable>& variables, const double* foreign,
                  double* ours);

/// Initial values of the declared variables: of a tensor as the description gives them, in our order.
void write_initial(const std::vector<ForeignVariable>& variables, double* ours);

/// NTENS that it is called with: the largest that it serves.
int components_served(const ForeignModel& model);
/// 3; a plane model else, where not all components are served, has 4.
bool is_of_plane_stress(const ForeignModel& model);
bool serves_all_components(const ForeignModel& model);

/// Throws PointFailure where a model of a plane is to shear out of it.
void require_served(const ForeignModel& model, const Tensor& F0, const Tensor& F1);

/// "0.25": for messages.
std::string shortest_text(double value);

}  // namespace assay::adapters
