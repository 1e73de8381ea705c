/* SPDX-License-Identifier: BSD-3-Clause */
/* A table that ends before `update`. */
#include "common.h"

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("short");
  table.struct_size = offsetof(assay_material, update);
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
