/* SPDX-License-Identifier: BSD-3-Clause */
/* Isotropic elasticity of increments without the strain of two fields: alpha for one unit of temperature, 1 for one
 * unit of a swelling. Constants: E, nu, alpha. */
#ifndef ASSAY_TEST_THERMAL_LAW_H
#define ASSAY_TEST_THERMAL_LAW_H

/* Component i of the stress of a strain whose first three components are normal, the others plain shears. */
static double thermal_stress(const double* constants, const double strain[6], double warmer, double swelling, int i) {
  const double E = constants[0], nu = constants[1], twice_G = E / (1 + nu), lambda = twice_G * nu / (1 - 2 * nu);
  const double own = constants[2] * warmer + swelling;
  if (i >= 3) return twice_G * strain[i];
  return lambda * (strain[0] + strain[1] + strain[2] - 3 * own) + twice_G * (strain[i] - own);
}

#endif
