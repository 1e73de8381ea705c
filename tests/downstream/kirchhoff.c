/* SPDX-License-Identifier: BSD-3-Clause */
/* Saint Venant-Kirchhoff elasticity as a plug-in in C: S = lambda tr(E) I + 2 mu E, sigma = F S F^T / J. */
#include <math.h>
#include <stdlib.h>

#include "harness/assay_material.h"

typedef struct { double lambda, mu; } Model;

static const assay_parameter parameters[] = {
    {"lambda", "Pa", NAN, -1e300, 1e300, "first Lame parameter"},
    {"mu", "Pa", NAN, 1e-300, 1e300, "shear modulus"},
};

static void *create(const double *p, char *message) {
  Model *self = malloc(sizeof *self);
  (void)message;
  if (self) self->lambda = p[0], self->mu = p[1];
  return self;
}

static void destroy(void *self) { free(self); }

static double determinant(double f[3][3]) {
  return f[0][0] * (f[1][1] * f[2][2] - f[1][2] * f[2][1]) - f[0][1] * (f[1][0] * f[2][2] - f[1][2] * f[2][0]) +
         f[0][2] * (f[1][0] * f[2][1] - f[1][1] * f[2][0]);
}

/* S of one point from its F. */
static void second_piola(const Model *m, double f[3][3], double S[3][3]) {
  double trace = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double C = 0;
      for (int k = 0; k < 3; ++k) C += f[k][i] * f[k][j];
      S[i][j] = m->mu * (C - (i == j)); /* 2 mu E */
      if (i == j) trace += 0.5 * (C - 1);
    }
  }
  for (int i = 0; i < 3; ++i) S[i][i] += m->lambda * trace;
}

static void update(void *self, const assay_step *step, size_t n, const double *state0, double *state1, double *cauchy,
                   int32_t *status, double *dt_factor, char *message) {
  (void)state0, (void)state1, (void)dt_factor, (void)message;
  for (size_t p = 0; p < n; ++p) {
    double f[3][3], S[3][3];
    for (int c = 0; c < 9; ++c) f[c / 3][c % 3] = step->F1[(size_t)c * n + p];
    second_piola(self, f, S);
    const double J = determinant(f);
    for (int c = 0; c < 9; ++c) {
      double sum = 0;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum += f[c / 3][k] * S[k][l] * f[c % 3][l];
      cauchy[(size_t)c * n + p] = sum / J;
    }
    status[p] = J > 0 ? ASSAY_GOOD : ASSAY_FAILED;
  }
}

static const assay_material table = {
    .abi_major = ASSAY_ABI_MAJOR, .struct_size = sizeof(assay_material),
    .name = "downstream_kirchhoff", .version = "1.0", .licence = "BSD-3-Clause", .doc = "Saint Venant-Kirchhoff",
    .symmetry = ASSAY_ISOTROPIC, .flags = ASSAY_THREAD_SAFE,
    .parameter_count = 2, .parameters = parameters,
    .create = create, .destroy = destroy, .update = update,
};

ASSAY_EXPORT const assay_material *assay_material_entry(uint32_t host_major, uint32_t index);

const assay_material *assay_material_entry(uint32_t host_major, uint32_t index) {
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
