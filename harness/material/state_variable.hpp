// SPDX-License-Identifier: BSD-3-Clause
// A state variable of one point as what it is: a number, a vector or a tensor; and where those of a material lie.
#pragma once

#include <vector>

#include "harness/material/material.hpp"
#include "harness/numeric/norms.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// Shear components times a factor.
inline Tensor sheared(Tensor A, double factor) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) A(i, j) *= i == j ? 1 : factor;
  }
  return A;
}

class Variable {
 public:
  /// kind: ASSAY_SCALAR, ASSAY_VECTOR, ASSAY_SYMMETRIC_TENSOR (11, 22, 33, 12, 13, 23) or ASSAY_TENSOR, row-major.
  Variable(std::int32_t kind, const double* components) : kind_(kind) {
    for (int c = 0; c < components_of_kind(kind); ++c) {
      component(value_, place(c)) = components[c];
      if (kind == ASSAY_SYMMETRIC_TENSOR) component(value_, mirror(c)) = components[c];
    }
  }

  /// As they lie in the state.
  void write(double* components) const {
    for (int c = 0; c < components_of_kind(kind_); ++c) components[c] = component(value_, place(c));
  }

  /// As the frame sees it after a rotation.
  Variable turned(const Tensor& Q) const {
    Variable result = *this;
    if (kind_ == ASSAY_VECTOR) result.value_ = Q * value_;
    if (is_tensor()) result.value_ = Q * value_ * Q.transpose();
    return result;
  }

  /// Another value of the same kind.
  Variable with(const Tensor& value) const {
    Variable result = *this;
    result.value_ = value;
    return result;
  }

  bool is_tensor() const { return kind_ == ASSAY_TENSOR || kind_ == ASSAY_SYMMETRIC_TENSOR; }
  const Tensor& value() const { return value_; }  ///< a vector: the first column
  double largest() const { return value_.cwiseAbs().maxCoeff(); }
  double distance(const Variable& other) const { return largest_of(value_ - other.value_); }

 private:
  /// Component of the tensor that component c of the variable is.
  int place(int c) const {
    constexpr int symmetric[] = {0, 4, 8, 1, 2, 5};
    return kind_ == ASSAY_SYMMETRIC_TENSOR ? symmetric[c] : kind_ == ASSAY_VECTOR ? 3 * c : c;
  }
  static int mirror(int c) {
    constexpr int symmetric[] = {0, 4, 8, 3, 6, 7};
    return symmetric[c];
  }

  std::int32_t kind_;
  Tensor value_ = Tensor::Zero();
};

/// A variable of a material's state, and its components among those of one point.
struct StatePlace {
  const char *name, *unit;
  std::int32_t kind, role;
  std::size_t first, size;

  std::size_t end() const { return first + size; }
  bool is_tensor() const { return kind == ASSAY_TENSOR || kind == ASSAY_SYMMETRIC_TENSOR; }
  bool turns_itself() const { return role == ASSAY_ROLE_ROTATES_ITSELF && is_tensor(); }  ///< as it declares
  Variable in(const std::vector<double>& state) const { return {kind, &state[first]}; }
};

/// All of them, as they are declared.
inline std::vector<StatePlace> state_of(const assay_material& table) {
  std::vector<StatePlace> all;
  std::size_t first = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const assay_state_variable& variable = table.state[v];
    const auto size = static_cast<std::size_t>(components_of_kind(variable.kind));
    all.push_back({variable.name, variable.unit, variable.kind, variable.role, first, size});
    first += size;
  }
  return all;
}

/// Of a point: components of the state that are fields of the surroundings, as they are declared.
inline std::vector<std::size_t> fields_of(const assay_material& table) {
  std::vector<std::size_t> all;
  for (const StatePlace& place : state_of(table)) {
    if (place.role == ASSAY_ROLE_FIELD) all.push_back(place.first);
  }
  return all;
}

}  // namespace assay
