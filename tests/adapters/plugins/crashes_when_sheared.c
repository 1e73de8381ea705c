/* SPDX-License-Identifier: BSD-3-Clause */
/* Ends its process at any point sheared by more than 0.4 of its `modulus` in thousands. */
#include <stdlib.h>

#include "common.h"

static void update_until_sheared(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                                 double* cauchy, int32_t* status, double* dt_factor, char* message) {
  for (size_t p = 0; p < n; ++p) {
    if (fabs(step->F1[n + p]) > 4e-4 * *(double*)self) abort();
  }
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("crashes_when_sheared");
  table.update = update_until_sheared;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
