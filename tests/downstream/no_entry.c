/* SPDX-License-Identifier: BSD-3-Clause */
/* A library without the entry symbol: assay_add_material must fail its build. */
#include "harness/assay_material.h"

int nothing_to_see(void);

int nothing_to_see(void) { return ASSAY_ABI_MAJOR; }
