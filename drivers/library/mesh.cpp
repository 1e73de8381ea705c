// SPDX-License-Identifier: BSD-3-Clause
// Of assay.h: consistent nodal forces of a mesh.
#include "drivers/library/exact_problem.hpp"

struct assay_mesh {
  assay::drivers::HandleMark mark = assay::drivers::HandleMark::mesh;
};

namespace assay::drivers {

extern "C" {

int assay_mesh_open(const assay_problem*, const assay_mesh_options*, assay_mesh** handle, assay_error* error) {
  if (handle) *handle = nullptr;
  return call_of_library(error, [&]() -> int { throw RefusedCall("mesh", "is not served yet"); });
}

void assay_mesh_close(assay_mesh* mesh) { close_handle(mesh, HandleMark::mesh); }

int assay_nodal_loads(const assay_mesh*, double, const assay_field*, assay_error* error) {
  return call_of_library(error, [&]() -> int { throw RefusedCall("mesh", "is not served yet"); });
}

int assay_at_current(const assay_problem*, double, size_t, int, const assay_const_field*, const assay_field*,
                     const assay_view*, assay_error* error) {
  return call_of_library(error, [&]() -> int { throw RefusedCall("x", "is not served yet"); });
}

}  // extern "C"

}  // namespace assay::drivers
