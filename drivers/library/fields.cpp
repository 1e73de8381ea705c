// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/library/fields.hpp"

#include <limits>

namespace assay::drivers {

std::vector<Vector3> vectors_of(std::size_t n, int dimension, const assay_const_field& field, const char* name) {
  refuse_call_if(n > 0 && !field.data, name, "must not be null");
  std::vector<Vector3> all(n, Vector3::Zero());
  for (std::size_t p = 0; p < n; ++p) {
    const double* at = field.data + static_cast<std::ptrdiff_t>(p) * field.point_stride;
    for (int d = 0; d < dimension; ++d) all[p](d) = at[d * field.component_stride];
    if (!all[p].allFinite()) throw RefusedCall(name, "must be numbers", ASSAY_BAD_INPUT, static_cast<std::int64_t>(p));
  }
  return all;
}

void check_components(int components, int dimension) {
  const bool fits = components == 3 || (components == 2 && dimension == 2);
  refuse_call_if(!fits, "components", dimension == 3 ? "must be 3 in three dimensions" : "must be 2 or 3");
}

Vector3 no_vector() { return Vector3::Constant(std::numeric_limits<double>::quiet_NaN()); }

void check_strides(const assay_field& field, std::size_t count, const char* name) {
  refuse_call_if(field.data && (field.component_stride == 0 || (field.point_stride == 0 && count > 1)), name,
                 "has a stride of 0: all numbers would be written to one place");
}

HostViews::HostViews(const assay_view* out, std::size_t count, int dimension, bool quasi_static) {
  const assay_view view = known_part(out, sizeof(assay_view), "out");
  refuse_call_if(view.reserved != 0, "out.reserved", "must be 0");
  const auto of = [count](const assay_field& field, const char* name) {
    check_strides(field, count, name);
    return FieldView{field.data, field.point_stride, field.component_stride};
  };
  fields = {static_cast<std::size_t>(dimension),
            of(view.x, "out.x"),
            of(view.v, "out.v"),
            of(view.a, "out.a"),
            of(view.F, "out.F"),
            of(view.P, "out.P"),
            of(view.sigma, "out.sigma"),
            of(view.b, "out.b"),
            of(view.b_static, "out.b_static")};
  status = view.status;
  if (!quasi_static || !fields.b) return;
  again = fields.static_force;
  fields.static_force = fields.b;
  fields.b = {};
}

void HostViews::put_outside(std::size_t point) const {
  ExactPoint none;
  none.state.x = none.state.v = none.state.a = no_vector();
  none.stress.body_force = none.stress.static_force = no_vector();
  none.state.F = none.stress.first_piola_kirchhoff = none.stress.cauchy = Tensor::Constant(no_vector().x());
  fields.put(point, none);
  finish(point, ASSAY_OUTSIDE);
}

}  // namespace assay::drivers
