/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls a function that nobody provides. */
#include "common.h"

int assay_test_provided_by_nobody(void);

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  (void)host_major, (void)index;
  return assay_test_provided_by_nobody() ? NULL : NULL;
}
