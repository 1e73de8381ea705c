/* SPDX-License-Identifier: BSD-3-Clause */
/* Cannot be created, and says why on two lines. */
#include "common.h"

static void* refuse(const double* p, char* message) {
  (void)p;
  strcpy(message, "no licence\nfor this model");
  return NULL;
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("refuses");
  table.create = refuse;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
