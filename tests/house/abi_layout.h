/* SPDX-License-Identifier: BSD-3-Clause */
/* Every size, offset and constant of the material ABI, as C and as the Fortran module see it: in the same order. */
#ifndef ASSAY_TESTS_ABI_LAYOUT_H
#define ASSAY_TESTS_ABI_LAYOUT_H

#include <stdint.h>

typedef struct {
  const char *name;
  int64_t value;
} abi_layout_entry;

#ifdef __cplusplus
extern "C" {
#endif
/* Returns the number of entries. */
int32_t abi_layout_c(const abi_layout_entry **entries);
/* Fills at most `room` values, returns their number. */
int32_t abi_layout_fortran(int32_t room, int64_t *values);
#ifdef __cplusplus
}
#endif

#endif /* ASSAY_TESTS_ABI_LAYOUT_H */
