/* SPDX-License-Identifier: BSD-3-Clause */
/* Anisotropic in Cartesian axes, with a required parameter and every kind of state. */
#include "common.h"

static const assay_parameter required[] = {{"modulus", "Pa", NAN, 1e-3, 1e9, "stiffness"},
                                           {"angle", "rad", 0.25, -INFINITY, INFINITY, "of the fibres"}};
static const assay_state_variable state[] = {
    {"damage", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "0 to 1"},
    {"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "direction"},
    {"back_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "kinematic hardening"},
};

static int32_t initial_state(void* self, size_t n, const double* cauchy, double* values) {
  (void)self, (void)cauchy;
  memset(values, 0, 10 * n * sizeof *values);
  return ASSAY_GOOD;
}

static void keep(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                 int32_t* status, double* dt_factor, char* message) {
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  memcpy(state1, state0, 10 * n * sizeof *state1);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("anisotropic");
  table.symmetry = ASSAY_ANISOTROPIC;
  table.flags = ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT;
  table.parameter_count = 2, table.parameters = required;
  table.state_count = 3, table.state = state, table.initial_state = initial_state;
  table.update = keep;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
