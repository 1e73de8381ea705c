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

HostViews::HostViews(const assay_view* out, int dimension) {
  const assay_view view = known_part(out, sizeof(assay_view), "out");
  refuse_call_if(view.reserved != 0, "out.reserved", "must be 0");
  const auto of = [](const assay_field& field) {
    return FieldView{field.data, field.point_stride, field.component_stride};
  };
  fields = {static_cast<std::size_t>(dimension),
            of(view.x),
            of(view.v),
            of(view.a),
            of(view.F),
            of(view.P),
            of(view.sigma),
            of(view.b),
            of(view.b_static)};
  status = view.status;
}

void HostViews::put_outside(std::size_t point) const {
  ExactPoint none;
  none.state.x = none.state.v = none.state.a = no_vector();
  none.stress.body_force = none.stress.static_force = no_vector();
  none.state.F = none.stress.first_piola_kirchhoff = none.stress.cauchy = Tensor::Constant(no_vector().x());
  fields.put(point, none);
  if (status) status[point] = ASSAY_OUTSIDE;
}

}  // namespace assay::drivers
