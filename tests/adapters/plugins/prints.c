/* SPDX-License-Identifier: BSD-3-Clause */
/* The tutorial model, with a line on standard output for every call. */
#include <stdio.h>

#include "harness/assay_material.h"

extern const assay_material* assay_builtin_neo_hookean(uint32_t host_major, uint32_t index);
ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

static void update(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                   int32_t* status, double* dt_factor, char* message) {
  printf("stress of %zu points at t = %.17g, which is all very well\n", n, step->t);
  assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0)
      ->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table;
  const assay_material* quiet = assay_builtin_neo_hookean(host_major, index);
  if (quiet == NULL) return NULL;
  table = *quiet;
  table.name = "prints";
  table.update = update;
  return &table;
}
