/* SPDX-License-Identifier: BSD-3-Clause */
/* Refuses, with a reason, any point sheared or stretched beyond 0.4 of its `modulus` in thousands. */
#include "common.h"

static void update_until_sheared(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                                 double* cauchy, int32_t* status, double* dt_factor, char* message) {
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (size_t p = 0; p < n; ++p) {
    for (size_t c = 0; c < 9; ++c) {
      if (fabs(step->F1[c * n + p] - (c % 4 == 0 ? 1.0 : 0.0)) > 4e-4 * *(double*)self) status[p] = ASSAY_FAILED;
    }
    if (status[p] == ASSAY_FAILED) strcpy(message, "deformed beyond its limit");
  }
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("fails_when_sheared");
  table.update = update_until_sheared;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
