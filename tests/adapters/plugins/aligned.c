/* SPDX-License-Identifier: BSD-3-Clause */
/* Two models that read, or write, two numbers at once from addresses that must be multiples of 16. */
#include <string.h>

#include "tests/adapters/plugins/common.h"

#if defined(__x86_64__)

static void load_two(const double* from) {
  __asm__ volatile("movapd %0, %%xmm0" : : "m"(*(const double(*)[2])from) : "xmm0");
}

static void store_two(double* to) {
  __asm__ volatile("movupd %0, %%xmm0\n\tmovapd %%xmm0, %0" : "+m"(*(double(*)[2])to) : : "xmm0");
}

#else

static void load_two(const double* from) { (void)from; }
static void store_two(double* to) { (void)to; }

#endif

static void update_by_loads(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                            double* cauchy, int32_t* status, double* dt_factor, char* message) {
  load_two(step->F1);
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
}

static void update_by_stores(void* self, const assay_step* step, size_t n, const double* state0, double* state1,
                             double* cauchy, int32_t* status, double* dt_factor, char* message) {
  update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
  store_two(cauchy);
}

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  static assay_material tables[] = {TEST_TABLE("loads"), TEST_TABLE("stores")};
  tables[0].update = update_by_loads;
  tables[1].update = update_by_stores;
  return host_major == ASSAY_ABI_MAJOR && index < 2 ? &tables[index] : NULL;
}
