/* SPDX-License-Identifier: BSD-3-Clause */
/* Broken on purpose: sigma += 2 mu d dt, in increments that forget to turn the stress that is there. */
#include <stdlib.h>
#include <string.h>

#include "harness/assay_material.h"

static const assay_parameter parameters[] = {{"mu", "Pa", 1e3, 1e-300, 1e300, "shear modulus"}};
static const assay_state_variable state[] = {
    {"stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress"}};

static void *create(const double *p, char *message) {
  double *self = malloc(sizeof *self);
  (void)message;
  if (self) *self = p[0];
  return self;
}

static void destroy(void *self) { free(self); }

static int32_t initial_state(void *self, size_t n, const double *cauchy, double *out) {
  (void)self;
  memcpy(out, cauchy, 9 * n * sizeof *out);
  return ASSAY_GOOD;
}

/* A^-1 of a 3x3 matrix. */
static void inverse(double A[3][3], double out[3][3]) {
  double det = 0;
  for (int j = 0; j < 3; ++j) {
    det += A[0][j] * (A[1][(j + 1) % 3] * A[2][(j + 2) % 3] - A[1][(j + 2) % 3] * A[2][(j + 1) % 3]);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3, s = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
      out[i][j] = (A[r][c] * A[s][d] - A[r][d] * A[s][c]) / det;
    }
  }
}

static void update(void *self, const assay_step *step, size_t n, const double *state0, double *state1, double *cauchy,
                   int32_t *status, double *dt_factor, char *message) {
  const double mu = *(const double *)self;
  (void)dt_factor, (void)message;
  for (size_t p = 0; p < n; ++p) {
    double middle[3][3], back[3][3], l[3][3] = {{0}};
    for (int c = 0; c < 9; ++c) middle[c / 3][c % 3] = 0.5 * (step->F0[c * n + p] + step->F1[c * n + p]);
    inverse(middle, back);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          l[i][j] += (step->F1[(3 * i + k) * n + p] - step->F0[(3 * i + k) * n + p]) * back[k][j];
        }
      }
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const size_t at = (size_t)(3 * i + j) * n + p;
        cauchy[at] = state1[at] = state0[at] + mu * (l[i][j] + l[j][i]);
      }
    }
    status[p] = ASSAY_GOOD;
  }
}

static const assay_material table = {
    .abi_major = ASSAY_ABI_MAJOR, .struct_size = sizeof(assay_material),
    .name = "downstream_unturned", .version = "1.0", .licence = "BSD-3-Clause", .doc = "broken on purpose",
    .symmetry = ASSAY_ISOTROPIC, .flags = ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT,
    .parameter_count = 1, .parameters = parameters, .state_count = 1, .state = state,
    .create = create, .destroy = destroy, .initial_state = initial_state, .update = update,
};

ASSAY_EXPORT const assay_material *assay_material_entry(uint32_t host_major, uint32_t index) {
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
