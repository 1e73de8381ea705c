// SPDX-License-Identifier: BSD-3-Clause
// Values to and from the memory of a host: views with strides.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "drivers/library/assay.h"
#include "drivers/library/call.hpp"
#include "harness/exact/exact_fields.hpp"

namespace assay::drivers {

inline Vector3 no_vector() { return Vector3::Constant(std::numeric_limits<double>::quiet_NaN()); }

inline double* place_in(const assay_field& field, std::size_t point) {
  return field.data + static_cast<std::ptrdiff_t>(point) * field.point_stride;
}

inline void put_vector(const assay_field& field, std::size_t point, const Vector3& value, int dimension) {
  if (!field.data) return;
  double* at = place_in(field, point);
  for (int d = 0; d < dimension; ++d) at[d * field.component_stride] = value(d);
}

/// n of them, 0 in the directions that the dimension has not. Throws RefusedCall at a component that is no number.
std::vector<Vector3> vectors_of(std::size_t n, int dimension, const assay_const_field& field, const char* name);

/// Throws RefusedCall.
void check_view(const assay_view& view);

/// Puts what is wanted of a point into a view, which has been checked.
class FieldWriter {
 public:
  FieldWriter(const assay_view& view, int dimension) : view_(view), dimension_(dimension) {}
  void put(std::size_t point, const ExactPoint& exact) const;
  /// NaN, for a point at which the motion is not defined.
  void put_outside(std::size_t point) const;

 private:
  void put_tensor(const assay_field& field, std::size_t point, const Tensor& value) const;

  const assay_view& view_;
  int dimension_;
};

}  // namespace assay::drivers
