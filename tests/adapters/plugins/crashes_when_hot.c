/* SPDX-License-Identifier: BSD-3-Clause */
/* Ends its process in a step at whose end the temperature is above 350. */
#include <stdlib.h>

#include "common.h"

static int32_t initial(void* self, size_t n, const double* cauchy, double* state) {
  (void)self, (void)cauchy;
  for (size_t p = 0; p < n; ++p) state[p] = 293;
  return ASSAY_GOOD;
}

static void update_until_hot(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                             double* cauchy, int32_t* status, double* dt_factor, char* message) {
  for (size_t p = 0; p < n; ++p) {
    if (state1[p] > 350) abort();
  }
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static const assay_state_variable temperature = {"temperature", "K", ASSAY_SCALAR, ASSAY_ROLE_FIELD, "of the air"};
  static assay_material table = TEST_TABLE("crashes_when_hot");
  table.state_count = 1, table.state = &temperature;
  table.initial_state = initial, table.update = update_until_hot;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
