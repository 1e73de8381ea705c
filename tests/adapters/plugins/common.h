/* SPDX-License-Identifier: BSD-3-Clause */
/* A model that answers (sigma = modulus (F - I), no state), from which each test plug-in differs in one respect. */
#ifndef ASSAY_TEST_PLUGIN_COMMON_H
#define ASSAY_TEST_PLUGIN_COMMON_H

#include <math.h>
#include <string.h>

#include "harness/assay_material.h"

static double modulus;

static const assay_parameter parameters[] = {{"modulus", "Pa", 1e3, 0, 1e12, "stiffness"}};

static inline void* create(const double* p, char* message) {
  (void)message;
  modulus = p[0];
  return &modulus;
}

static inline void destroy(void* self) { (void)self; }

static inline void update(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                          double* cauchy, int32_t* status, double* dt_factor, char* message) {
  (void)state0, (void)state1, (void)dt_factor, (void)message;
  for (size_t p = 0; p < n; ++p) {
    for (size_t c = 0; c < 9; ++c) {
      cauchy[c * n + p] = *(double*)self * (step->F1[c * n + p] - (c % 4 == 0 ? 1.0 : 0.0));
    }
    status[p] = ASSAY_GOOD;
  }
}

#define TEST_TABLE(model)                                                                                             \
  {                                                                                                                   \
    .abi_major = ASSAY_ABI_MAJOR, .struct_size = sizeof(assay_material), .name = model, .version = "0.1",             \
    .licence = "BSD-3-Clause", .doc = "test model", .parameter_count = 1, .parameters = parameters, .create = create, \
    .destroy = destroy, .update = update                                                                              \
  }

ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

#endif
