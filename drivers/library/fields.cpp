// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/library/fields.hpp"

#include <cmath>

namespace assay::drivers {

std::vector<Vector3> vectors_of(std::size_t n, int dimension, const assay_const_field& field, const char* name) {
  std::vector<Vector3> all(n, Vector3::Zero());
  for (std::size_t p = 0; p < n; ++p) {
    const double* at = field.data + static_cast<std::ptrdiff_t>(p) * field.point_stride;
    for (int d = 0; d < dimension; ++d) all[p](d) = at[d * field.component_stride];
    if (!all[p].allFinite()) throw RefusedCall(name, "must be numbers", ASSAY_BAD_INPUT, static_cast<std::int64_t>(p));
  }
  return all;
}

void check_view(const assay_view& view) { refuse_call_if(view.reserved != 0, "out.reserved", "must be 0"); }

void FieldWriter::put_tensor(const assay_field& field, std::size_t point, const Tensor& value) const {
  if (!field.data) return;
  double* at = place_in(field, point);
  for (int c = 0; c < 9; ++c) at[c * field.component_stride] = component(value, c);
}

void FieldWriter::put(std::size_t point, const ExactPoint& exact) const {
  if (view_.status) view_.status[point] = ASSAY_DONE;
  put_vector(view_.x, point, exact.state.x, dimension_);
  put_vector(view_.v, point, exact.state.v, dimension_);
  put_vector(view_.a, point, exact.state.a, dimension_);
  put_tensor(view_.F, point, exact.state.F);
  put_tensor(view_.P, point, exact.stress.first_piola_kirchhoff);
  put_vector(view_.b, point, exact.stress.body_force, dimension_);
  put_vector(view_.b_static, point, exact.stress.body_force - exact.state.a, dimension_);
  if (!view_.sigma.data) return;
  constexpr int components[] = {0, 4, 8, 1, 2, 5};  // 11, 22, 33, 12, 13, 23
  double* at = place_in(view_.sigma, point);
  for (int c = 0; c < 6; ++c) at[c * view_.sigma.component_stride] = component(exact.stress.cauchy, components[c]);
}

void FieldWriter::put_outside(std::size_t point) const {
  ExactPoint none;
  none.state.x = none.state.v = none.state.a = none.stress.body_force = no_vector();
  none.state.F = none.stress.first_piola_kirchhoff = none.stress.cauchy = Tensor::Constant(no_vector().x());
  put(point, none);
  if (view_.status) view_.status[point] = ASSAY_OUTSIDE;
}

}  // namespace assay::drivers
