/* SPDX-License-Identifier: BSD-3-Clause */
/* Keeps its largest shear as state and, once that exceeds 0.4 of its `modulus` in thousands, cannot go on: refuses the
 * step where `modulus` is at least 1000, gives NaN below. */
#include "common.h"

static const assay_state_variable state[] = {
    {"largest_shear", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "largest |F21| so far"}};

static void update_with_memory(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                               double* cauchy, int32_t* status, double* dt_factor, char* message) {
  const double stiffness = *(double*)self;
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (size_t p = 0; p < n; ++p) {
    state1[p] = fmax(state0[p], fabs(step->F1[3 * n + p]));
    if (state1[p] <= 4e-4 * stiffness) continue;
    cauchy[p] = NAN;
    if (stiffness < 1000) continue;
    status[p] = ASSAY_FAILED;
    strcpy(message, "sheared beyond its limit");
  }
}

static int32_t at_rest(void* self, size_t n, const double* cauchy, double* largest) {
  (void)self, (void)cauchy;
  memset(largest, 0, n * sizeof(double));
  return ASSAY_GOOD;
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("fails_midway");
  table.state_count = 1;
  table.state = state;
  table.initial_state = at_rest;
  table.update = update_with_memory;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
