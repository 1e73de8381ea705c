/* SPDX-License-Identifier: BSD-3-Clause */
/* Compressible neo-Hookean elasticity, (34): sigma = (lambda ln J / J) I + (mu / J) (F F^T - I). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harness/assay_material.h"

typedef struct { double lambda, mu; } Model;

static const assay_parameter parameters[] = {
    {"E", "Pa", NAN, 1e-300, 1e300, "Young's modulus"},
    {"nu", "1", 0.3, -0.999999, 0.499999999, "Poisson's ratio"},
};

static void *create(const double *p, char *message) {
  Model *self = malloc(sizeof *self);
  (void)message;
  if (!self) return NULL;
  self->lambda = p[0] * p[1] / ((1 + p[1]) * (1 - 2 * p[1]));
  self->mu = p[0] / (2 * (1 + p[1]));
  return self;
}

static double determinant(const double *F, size_t n) {
  return F[0] * (F[4 * n] * F[8 * n] - F[5 * n] * F[7 * n]) - F[n] * (F[3 * n] * F[8 * n] - F[5 * n] * F[6 * n]) +
         F[2 * n] * (F[3 * n] * F[7 * n] - F[4 * n] * F[6 * n]);
}

static void update(void *self, const assay_step *step, size_t n, const double *state0, double *state1, double *cauchy,
                   int32_t *status, double *dt_factor, char *message) {
  const Model m = *(const Model *)self;
  (void)state0, (void)state1, (void)dt_factor;
  for (size_t p = 0; p < n; ++p) {
    const double *F = step->F1 + p;
    const double J = determinant(F, n);
    const double pressure = m.lambda * log(J) / J, shear = m.mu / J;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        double b = i == j ? -1.0 : 0.0; /* F F^T - I */
        for (int k = 0; k < 3; ++k) b += F[(3 * i + k) * n] * F[(3 * j + k) * n];
        cauchy[(3 * i + j) * n + p] = shear * b + (i == j ? pressure : 0.0);
      }
    }
    status[p] = J > 0 ? ASSAY_GOOD : ASSAY_FAILED;
    if (!(J > 0)) strcpy(message, "det F <= 0");
  }
}

static void destroy(void *self) { free(self); }

const void *neo_hookean_extension(const char *id); /* optional abilities, neo_hookean_extensions.c */

static const assay_material table = {
    .abi_major = ASSAY_ABI_MAJOR, .struct_size = sizeof(assay_material),
    .name = "neo_hookean", .version = "1.0", .licence = "BSD-3-Clause", .doc = "compressible neo-Hookean elasticity (34)",
    .symmetry = ASSAY_ISOTROPIC, .flags = ASSAY_THREAD_SAFE,
    .parameter_count = 2, .parameters = parameters,
    .create = create, .destroy = destroy, .update = update, .extension = neo_hookean_extension,
};

#ifndef ASSAY_PLUGIN /* built in: the entries of all models live in one program */
#define assay_material_entry assay_builtin_neo_hookean
#endif
ASSAY_EXPORT const assay_material *assay_material_entry(uint32_t host_major, uint32_t index);

const assay_material *assay_material_entry(uint32_t host_major, uint32_t index) {
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
