// SPDX-License-Identifier: BSD-3-Clause
// Values to and from the memory of a host: views with strides.
#pragma once

#include <cstddef>
#include <optional>
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

/// Throws RefusedCall where several numbers would be written to one place.
void check_strides(const assay_field& field, std::size_t count, const char* name);

inline void put_vector(const assay_field& field, std::size_t point, const Vector3& value, int dimension) {
  double* at = field.data + static_cast<std::ptrdiff_t>(point) * field.point_stride;
  for (int d = 0; d < dimension; ++d) at[d * field.component_stride] = value(d);
}

Vector3 no_vector();  ///< NaN

/// What a host wants of points, and where.
struct HostViews {
  /// Of so many points. quasi_static: b is to be without inertia. Throws RefusedCall.
  HostViews(const assay_view* out, std::size_t count, int dimension, bool quasi_static);

  /// Behind the fields of a point.
  void finish(std::size_t point, std::int32_t code = ASSAY_DONE) const {
    if (status) status[point] = code;
    for (std::size_t d = 0; again && d < fields.dimension; ++d) again.at(point, d) = fields.static_force.at(point, d);
  }
  /// NaN, for a point at which the motion is not defined.
  void put_outside(std::size_t point) const;

  FieldViews fields;
  FieldView again = {};  ///< where the force without inertia is wanted a second time
  std::int32_t* status;
};

/// Of points that have been filled: the code, or RefusedCall with the first one that lies outside.
inline int code_of_points(const std::optional<std::size_t>& outside) {
  if (!outside) return ASSAY_DONE;
  throw RefusedCall("points", "points lie where the motion is not defined", ASSAY_OUTSIDE,
                    static_cast<std::int64_t>(*outside));
}

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
