/* SPDX-License-Identifier: BSD-3-Clause */
/* Computes with what a variable of the environment says, as others do with what a file says. */
#include "common.h"
#include <stdlib.h>

static void update_by_variable(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                               double* cauchy, int32_t* status, double* dt_factor, char* message) {
  const char* share = getenv("ASSAY_TEST_SHARE");
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  for (size_t c = 0; c < 9 * n; ++c) cauchy[c] *= share ? atof(share) : 1;
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("asks_its_environment");
  table.update = update_by_variable;
  table.flags |= ASSAY_RATE_DEPENDENT; /* a curve is not kept */
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
