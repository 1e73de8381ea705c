/* SPDX-License-Identifier: BSD-3-Clause */
/* Layout of the material ABI as one compiler of one language sees it: C and C++ must agree on every number. */
#ifndef ASSAY_TESTS_ABI_FACTS_H
#define ASSAY_TESTS_ABI_FACTS_H

#include <stddef.h>

#include "harness/assay_material.h"

#define ABI_FACT_COUNT 16

#define ABI_FACT_LIST                                                                                              \
  sizeof(assay_material), sizeof(assay_parameter), sizeof(assay_state_variable), sizeof(assay_step),               \
      sizeof(assay_rate), sizeof(assay_tangent), sizeof(assay_energy), sizeof(assay_wave_speed),                   \
      sizeof(assay_closed_form), offsetof(assay_material, name), offsetof(assay_material, parameter_count),        \
      offsetof(assay_material, create), offsetof(assay_material, initial_state), offsetof(assay_material, update), \
      offsetof(assay_material, extension), (size_t)ASSAY_NON_SMOOTH | ASSAY_RATE_DEPENDENT

#ifdef __cplusplus
extern "C" {
#endif
void facts_abi_c11(size_t facts[ABI_FACT_COUNT]);
void facts_abi_cxx17(size_t facts[ABI_FACT_COUNT]);
void facts_abi_cxx20(size_t facts[ABI_FACT_COUNT]);
#ifdef __cplusplus
}
#endif

#endif /* ASSAY_TESTS_ABI_FACTS_H */
