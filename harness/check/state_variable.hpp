// SPDX-License-Identifier: BSD-3-Clause
// A state variable of one point as what it is: a number, a vector or a tensor.
#pragma once

#include "harness/material.hpp"
#include "harness/tensor.hpp"

namespace assay::check {

class Variable {
 public:
  /// kind: ASSAY_SCALAR, ASSAY_VECTOR, ASSAY_SYMMETRIC_TENSOR (11, 22, 33, 12, 13, 23) or ASSAY_TENSOR, row-major.
  Variable(std::int32_t kind, const double* components) : kind_(kind) {
    constexpr int place[] = {0, 4, 8, 1, 2, 5}, mirror[] = {0, 4, 8, 3, 6, 7};
    for (int c = 0; c < components_of_kind(kind); ++c) {
      if (kind == ASSAY_SYMMETRIC_TENSOR) {
        component(value_, place[c]) = component(value_, mirror[c]) = components[c];
      } else {
        component(value_, kind == ASSAY_VECTOR ? 3 * c : c) = components[c];  // a vector: the first column
      }
    }
  }

  /// As the frame sees it after a rotation.
  Variable turned(const Tensor& Q) const {
    Variable result = *this;
    if (kind_ == ASSAY_VECTOR) result.value_ = Q * value_;
    if (kind_ == ASSAY_TENSOR || kind_ == ASSAY_SYMMETRIC_TENSOR) result.value_ = Q * value_ * Q.transpose();
    return result;
  }

  double largest() const { return value_.cwiseAbs().maxCoeff(); }
  double distance(const Variable& other) const { return (value_ - other.value_).cwiseAbs().maxCoeff(); }

 private:
  std::int32_t kind_;
  Tensor value_ = Tensor::Zero();
};

}  // namespace assay::check
