/* SPDX-License-Identifier: BSD-3-Clause */
/* Has routines that are called as others in libraries of the program: of zlib, of libc. Refuses where it gets those. */
#include "common.h"

#define OWN __attribute__((visibility("default"), noinline))

OWN int compress(int value);
OWN int crc32(int value);
OWN int getsubopt(int value);
int compress(int value) { return value + 1; }
int crc32(int value) { return value + 2; }
int getsubopt(int value) { return value + 3; }

static void update_by_own(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                          double* cauchy, int32_t* status, double* dt_factor, char* message) {
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  const int zero = (int)(n >> 20);
  if (compress(zero) == 1 && crc32(zero) == 2 && getsubopt(zero) == 3) return;
  status[0] = ASSAY_FAILED;
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material table = TEST_TABLE("own_names");
  table.update = update_by_own;
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
