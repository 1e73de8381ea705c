/* SPDX-License-Identifier: BSD-3-Clause */
/* A plug-in of ABI 1.0 as it was first published: it must load for ever. Pressure kappa ln J / J. */
#include <math.h>
#include <stdlib.h>

#include "assay_material.h" /* the frozen copy beside this file */

static const assay_parameter parameters[] = {{"kappa", "Pa", 1e3, 0, 1e12, "bulk modulus"}};
static const assay_state_variable state[] = {{"volume", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "J"}};

static void* create(const double* p, char* message) {
  double* self = malloc(sizeof *self);
  (void)message;
  if (self) *self = p[0];
  return self;
}

static void destroy(void* self) { free(self); }

static int32_t initial_state(void* self, size_t n, const double* cauchy, double* volume) {
  (void)self, (void)cauchy;
  for (size_t p = 0; p < n; ++p) volume[p] = 1;
  return ASSAY_GOOD;
}

static void update(void* self, const assay_step* step, size_t n, const double* state0, double* state1, double* cauchy,
                   int32_t* status, double* dt_factor, char* message) {
  (void)state0, (void)dt_factor, (void)message;
  for (size_t p = 0; p < n; ++p) {
    const double* F = step->F1 + p;
    const double J = F[0] * (F[4 * n] * F[8 * n] - F[5 * n] * F[7 * n]) -
                     F[n] * (F[3 * n] * F[8 * n] - F[5 * n] * F[6 * n]) +
                     F[2 * n] * (F[3 * n] * F[7 * n] - F[4 * n] * F[6 * n]);
    for (int c = 0; c < 9; ++c) cauchy[(size_t)c * n + p] = c % 4 == 0 ? *(double*)self * log(J) / J : 0;
    state1[p] = J;
    status[p] = J > 0 ? ASSAY_GOOD : ASSAY_FAILED;
  }
}

static const assay_material table = {ASSAY_ABI_MAJOR,
                                     sizeof(assay_material),
                                     "frozen",
                                     "1.0",
                                     "BSD-3-Clause",
                                     "volumetric elasticity",
                                     ASSAY_ISOTROPIC,
                                     ASSAY_THREAD_SAFE,
                                     1,
                                     1,
                                     parameters,
                                     state,
                                     create,
                                     destroy,
                                     initial_state,
                                     update,
                                     NULL};

ASSAY_EXPORT const assay_material* assay_material_entry(uint32_t host_major, uint32_t index);

const assay_material* assay_material_entry(uint32_t host_major, uint32_t index) {
  return host_major == 1 && index == 0 ? &table : NULL;
}
