/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers as it is asked before a run, for a few points or at the 18 neighbours of each of some, and dies of the many of
 * a body. */
#include <stdlib.h>

#include "common.h"

static void update_until_death(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                               double* cauchy, int32_t* status, double* dt_factor, char* message) {
  const size_t neighbours = 18;
  if (n > 60 && n % neighbours != 0) abort();
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("crashes_in_a_run");
  table.update = update_until_death;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
