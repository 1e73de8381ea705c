/* SPDX-License-Identifier: BSD-3-Clause */
/* Compressible neo-Hookean elasticity, (34): sigma = (lambda ln J / J) I + (mu / J) (F F^T - I). */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adapters/models/vector_log.h"
#include "harness/assay_material.h"
#include "harness/numeric/vector_clones.h"

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

static double determinant(const double F[9]) {
  return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
}

/* In loops that vectorise: one for J, one for ln J, one for the stress. */
ASSAY_VECTOR_CLONES
static void update(void *self, const assay_step *step, size_t n, const double *state0, double *state1, double *cauchy,
                   int32_t *status, double *dt_factor, char *message) {
  const Model m = *(const Model *)self;
  const double *restrict F1 = step->F1;
  double *restrict sigma = cauchy;
  double J[ASSAY_BATCH_MAX], pressure[ASSAY_BATCH_MAX];
  (void)state0, (void)state1, (void)dt_factor;
  int bad = 0;
  for (size_t p = 0; p < n; ++p) {
    double F[9];
    for (size_t c = 0; c < 9; ++c) F[c] = F1[c * n + p];
    J[p] = determinant(F);
  }
  for (size_t p = 0; p < n; ++p) pressure[p] = m.lambda * vector_log(J[p]) / J[p];
  for (size_t p = 0; p < n; ++p) {
    double F[9];
    for (size_t c = 0; c < 9; ++c) F[c] = F1[c * n + p];
    const double shear = m.mu / J[p];
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 3; ++j) {
        const double b = F[3 * i] * F[3 * j] + F[3 * i + 1] * F[3 * j + 1] + F[3 * i + 2] * F[3 * j + 2]; /* F F^T */
        sigma[(3 * i + j) * n + p] = i == j ? pressure[p] + shear * (b - 1) : shear * b;
      }
    }
  }
  for (size_t p = 0; p < n; ++p) {
    status[p] = J[p] > 0 ? ASSAY_GOOD : ASSAY_FAILED;
    bad |= !(J[p] > 0);
  }
  if (bad) strcpy(message, "det F <= 0");
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
