/* SPDX-License-Identifier: BSD-3-Clause */
/* Optional abilities of the neo-Hookean model (34): stored energy, wave speed, closed forms of the baselines. */
#include <math.h>
#include <string.h>

#include "harness/assay_material.h"

typedef struct { double lambda, mu; } Model; /* as in neo_hookean.c */

const void *neo_hookean_extension(const char *id);

static double determinant(const double F[9]) {
  return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
}

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

const void *neo_hookean_extension(const char *id) {
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
