/* SPDX-License-Identifier: BSD-3-Clause */
/* Labels that a terminal would obey, and that would look like lines of the program. */
#include "common.h"

static const assay_parameter hostile[] = {
    {"modulus", "Pa\x1b[31m", 1e3, 0, 1e12, "stiffness\x1b]0;title\x07\nregistered FORGED"}};

static const assay_material table = {.abi_major = ASSAY_ABI_MAJOR,
                                     .struct_size = sizeof(assay_material),
                                     .name = "hostile_labels",
                                     .version = "0.1\x1b[2J",
                                     .licence = "BSD\nFORGED: pass",
                                     .doc = "a model \xe2\x80\xae\x1b[8m\nFORGED: pass",
                                     .parameter_count = 1,
                                     .parameters = hostile,
                                     .create = create,
                                     .destroy = destroy,
                                     .update = update};

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  (void)parameters;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
