/* SPDX-License-Identifier: BSD-3-Clause */
/* A spring that is pressed together when it is undeformed. */
#include "tests/adapters/plugins/common.h"

ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

static void pressed(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                    int32_t* status, double* dt_factor, char* message) {
  const double pressure = 0.1 * *(double*)self;
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (size_t p = 0; p < n; ++p) {
    for (size_t c = 0; c < 9; c += 4) cauchy[c * n + p] -= pressure;
  }
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("pressed_at_rest");
  if (host_major != ASSAY_ABI_MAJOR || index != 0) return NULL;
  table.update = pressed;
  return &table;
}
