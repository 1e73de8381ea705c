/* SPDX-License-Identifier: BSD-3-Clause */
/* One library, two models. */
#include "common.h"

static const assay_material first = TEST_TABLE("first"), second = TEST_TABLE("second");

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  const assay_material* tables[] = {&first, &second};
  return host_major == ASSAY_ABI_MAJOR && index < 2 ? tables[index] : NULL;
}
