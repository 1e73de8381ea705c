/* SPDX-License-Identifier: BSD-3-Clause */
/* Answers to any host with a table of another major. */
#include "common.h"

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("stubborn");
  (void)host_major;
  table.abi_major = 7;
  return index == 0 ? &table : NULL;
}
