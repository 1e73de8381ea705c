/* SPDX-License-Identifier: BSD-3-Clause */
/* A spring whose stiffness is that of the first instance of the process. */
#include <stdlib.h>

#include "tests/adapters/plugins/common.h"

ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

static double of_the_first = -1;

static void* keep_first(const double* p, char* message) {
  (void)message;
  if (of_the_first < 0) of_the_first = p[0];
  double* self = malloc(sizeof *self);
  if (self != NULL) *self = of_the_first;
  return self;
}

static void release(void* self) { free(self); }

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("first_instance");
  if (host_major != ASSAY_ABI_MAJOR || index != 0) return NULL;
  table.create = keep_first;
  table.destroy = release;
  return &table;
}
