/* SPDX-License-Identifier: BSD-3-Clause */
/* Its stress is NaN, though it calls every point good. */
#include "common.h"

static void bad_update(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                       double* cauchy, int32_t* status, double* dt_factor, char* message) {
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  cauchy[0] = NAN;
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("not_finite");
  table.update = bad_update;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
