// SPDX-License-Identifier: BSD-3-Clause
// Values to and from the memory of a host: views with strides.
#pragma once

#include <cstddef>
#include <vector>

#include "drivers/library/assay.h"
#include "drivers/library/call.hpp"
#include "harness/exact/places.hpp"
#include "harness/material/material_failure.hpp"

namespace assay::drivers {

/// n of them, 0 in the directions that the dimension has not. Throws RefusedCall at a component that is no number.
std::vector<Vector3> vectors_of(std::size_t n, int dimension, const assay_const_field& field, const char* name);

/// Throws RefusedCall where the number of components of given positions is none of the dimension's.
void check_components(int components, int dimension);

inline void put_vector(const assay_field& field, std::size_t point, const Vector3& value, int dimension) {
  double* at = field.data + static_cast<std::ptrdiff_t>(point) * field.point_stride;
  for (int d = 0; d < dimension; ++d) at[d * field.component_stride] = value(d);
}

Vector3 no_vector();  ///< NaN

/// What a host wants of points, and where.
struct HostViews {
  /// Throws RefusedCall.
  HostViews(const assay_view* out, int dimension);

  void tell_inside(std::size_t point) const {
    if (status) status[point] = ASSAY_DONE;
  }
  /// NaN, for a point at which the motion is not defined.
  void put_outside(std::size_t point) const;

  FieldViews fields;
  std::int32_t* status;
};

inline int code_of_points(bool all_inside) { return all_inside ? ASSAY_DONE : ASSAY_OUTSIDE; }

/// Of a point, what `found()` finds there. A material that fails is a finding at the point.
template <class Found>
auto at_point(std::size_t point, const Found& found) {
  try {
    return found();
  } catch (const MaterialFailure& failure) {
    throw RefusedCall("points", failure.what(), ASSAY_FINDING, static_cast<std::int64_t>(point));
  }
}

}  // namespace assay::drivers
