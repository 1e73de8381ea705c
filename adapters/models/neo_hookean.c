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

/* Optional abilities: stored energy, wave speed, closed forms of the baselines. */

static void point(const double *a, size_t n, size_t p, double out[9]) {
  for (int c = 0; c < 9; ++c) out[c] = a[(size_t)c * n + p];
}

/* W = lambda/2 ln^2 J - mu ln J + mu/2 (tr C - 3) */
static int32_t energy(void *self, size_t n, const double *F, const double *state, double *W) {
  const Model m = *(const Model *)self;
  (void)state;
  for (size_t p = 0; p < n; ++p) {
    double f[9], trace_C = 0;
    point(F, n, p, f);
    for (int c = 0; c < 9; ++c) trace_C += f[c] * f[c];
    const double ln_J = log(determinant(f));
    W[p] = 0.5 * m.lambda * ln_J * ln_J - m.mu * ln_J + 0.5 * m.mu * (trace_C - 3);
  }
  return ASSAY_GOOD;
}

/* Largest eigenvalue of the symmetric B = F F^T, by its trigonometric closed form. */
static double largest_square_stretch(const double F[9]) {
  double B[6] = {0}; /* 11,22,33,12,13,23 */
  for (int k = 0; k < 3; ++k) {
    B[0] += F[k] * F[k], B[1] += F[3 + k] * F[3 + k], B[2] += F[6 + k] * F[6 + k];
    B[3] += F[k] * F[3 + k], B[4] += F[k] * F[6 + k], B[5] += F[3 + k] * F[6 + k];
  }
  const double mean = (B[0] + B[1] + B[2]) / 3, off = B[3] * B[3] + B[4] * B[4] + B[5] * B[5];
  const double x = B[0] - mean, y = B[1] - mean, z = B[2] - mean;
  const double q = sqrt((x * x + y * y + z * z + 2 * off) / 6);
  if (q == 0) return mean;
  const double det = x * (y * z - B[5] * B[5]) - B[3] * (B[3] * z - B[5] * B[4]) + B[4] * (B[3] * B[5] - y * B[4]);
  const double r = fmax(-1, fmin(1, det / (2 * q * q * q)));
  return mean + 2 * q * cos(acos(r) / 3);
}

/* Acoustic tensor of (34) along n: [mu n.B n I + (lambda + mu - lambda ln J) n n] / J, so that
 * rho c^2 = (mu n.B n + lambda + mu - lambda ln J) / J with rho = rho0 / J; the largest over n. */
static int32_t wave_speed(void *self, double density, size_t n, const double *F, const double *cauchy,
                          const double *state, double *speed) {
  const Model m = *(const Model *)self;
  (void)cauchy, (void)state;
  for (size_t p = 0; p < n; ++p) {
    double f[9];
    point(F, n, p, f);
    const double along = fmax(0, m.lambda + m.mu - m.lambda * log(determinant(f)));
    speed[p] = sqrt((m.mu * largest_square_stretch(f) + along) / density);
  }
  return ASSAY_GOOD;
}

/* Simple shear: tau12 = tau21 = 2 mu eps. Uniaxial strain with stretch s = 1 + eps, (39), (40) as reference forces. */
static int32_t closed_form(void *self, int32_t baseline, size_t n, const double *eps, double *tau, double *dtau) {
  const Model m = *(const Model *)self;
  memset(tau, 0, 9 * n * sizeof *tau);
  memset(dtau, 0, 9 * n * sizeof *dtau);
  for (size_t p = 0; p < n; ++p) {
    const double s = 1 + eps[p];
    if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) {
      tau[n + p] = tau[3 * n + p] = 2 * m.mu * eps[p];
      dtau[n + p] = dtau[3 * n + p] = 2 * m.mu;
    } else if (baseline == ASSAY_BASELINE_UNIAXIAL_STRAIN) {
      tau[p] = m.lambda * log(s) / s + m.mu * (s - 1 / s);
      dtau[p] = m.lambda * (1 - log(s)) / (s * s) + m.mu * (1 + 1 / (s * s));
      tau[4 * n + p] = tau[8 * n + p] = m.lambda * log(s);
      dtau[4 * n + p] = dtau[8 * n + p] = m.lambda / s;
    } else {
      return ASSAY_FAILED;
    }
  }
  return ASSAY_GOOD;
}

static const void *extension(const char *id) {
  static const assay_energy energy_table = {sizeof(assay_energy), energy};
  static const assay_wave_speed speed_table = {sizeof(assay_wave_speed), wave_speed};
  static const assay_closed_form closed_form_table = {sizeof(assay_closed_form), closed_form};
  static const double example[] = {1e3, 0.3};
  static const assay_example example_table = {sizeof(assay_example), example};
  if (strcmp(id, ASSAY_EXTENSION_EXAMPLE) == 0) return &example_table;
  if (strcmp(id, ASSAY_EXTENSION_ENERGY) == 0) return &energy_table;
  if (strcmp(id, ASSAY_EXTENSION_WAVE_SPEED) == 0) return &speed_table;
  if (strcmp(id, ASSAY_EXTENSION_CLOSED_FORM) == 0) return &closed_form_table;
  return NULL;
}

static const assay_material table = {
    .abi_major = ASSAY_ABI_MAJOR, .struct_size = sizeof(assay_material),
    .name = "neo_hookean", .version = "1.0", .licence = "BSD-3-Clause", .doc = "compressible neo-Hookean elasticity (34)",
    .symmetry = ASSAY_ISOTROPIC, .flags = ASSAY_THREAD_SAFE,
    .parameter_count = 2, .parameters = parameters,
    .create = create, .destroy = destroy, .update = update, .extension = extension,
};

#ifndef ASSAY_PLUGIN /* built in: the entries of all models live in one program */
#define assay_material_entry assay_builtin_neo_hookean
#endif
ASSAY_EXPORT const assay_material *assay_material_entry(uint32_t host_major, uint32_t index);

const assay_material *assay_material_entry(uint32_t host_major, uint32_t index) {
  return host_major == ASSAY_ABI_MAJOR && index == 0 ? &table : NULL;
}
