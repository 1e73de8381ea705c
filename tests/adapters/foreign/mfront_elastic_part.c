/* SPDX-License-Identifier: BSD-3-Clause */
/* A library of MFront's generic interface: a finite strain behaviour that keeps the elastic part of F, as those of
 * single crystals do, and lets it begin where its user says. Neo-Hookean elasticity of that part; no tangent. */
#include "mfront_behaviour.h"

MFRONT_DESCRIPTION(ElasticPart)
TEXT(ElasticPart_unit_system, "")
ARRAY(int, ElasticPart_GradientsTypes, 1, 3)
ARRAY(const char*, ElasticPart_Gradients, 1, "DeformationGradient")
ARRAY(const char*, ElasticPart_TangentOperatorBlocks, 2, "Stress", "DeformationGradient")
NUMBER(ElasticPart_BehaviourType, 2)
NUMBER(ElasticPart_BehaviourKinematic, 3)
MFRONT_HYPOTHESIS(ElasticPart)
NUMBER(ElasticPart_nMaterialProperties, 2)
ARRAY(const char*, ElasticPart_MaterialProperties, 2, "Lambda", "Mu")
NUMBER(ElasticPart_nInternalStateVariables, 1)
ARRAY(const char*, ElasticPart_InternalStateVariables, 1, "Fe")
ARRAY(int, ElasticPart_InternalStateVariablesTypes, 1, 3)
NUMBER(ElasticPart_nParameters, 0)
SYMBOL(const char* const*, ElasticPart_Parameters, NULL)
SYMBOL(const int*, ElasticPart_ParametersTypes, NULL)
NUMBER(ElasticPart_requiresStiffnessTensor, 0)
NUMBER(ElasticPart_ComputesDissipatedEnergy, 0)

EXPORT int ElasticPart_Tridimensional(BehaviourData* const d);

/* 11, 22, 33, 12, 21, 13, 31, 23, 32 */
static const int row[9] = {0, 1, 2, 0, 1, 0, 2, 1, 2}, column[9] = {0, 1, 2, 1, 0, 2, 0, 2, 1};

static void read_tensor(const double* nine, double A[3][3]) {
  for (int c = 0; c < 9; ++c) A[row[c]][column[c]] = nine[c];
}

/* Returns det A. */
static double invert(double A[3][3], double inverse[3][3]) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, e = (j + 2) % 3;
      inverse[j][i] = A[a][c] * A[b][e] - A[a][e] * A[b][c];
    }
  }
  const double J = A[0][0] * inverse[0][0] + A[0][1] * inverse[1][0] + A[0][2] * inverse[2][0];
  for (int c = 0; c < 9; ++c) inverse[row[c]][column[c]] /= J;
  return J;
}

static void multiply(double A[3][3], double B[3][3], double C[3][3]) {
  for (int c = 0; c < 9; ++c) {
    const int i = row[c], j = column[c];
    C[i][j] = A[i][0] * B[0][j] + A[i][1] * B[1][j] + A[i][2] * B[2][j];
  }
}

int ElasticPart_Tridimensional(BehaviourData* const d) {
  double F0[3][3], F1[3][3], Fe0[3][3], Fe[3][3], inverse[3][3], increment[3][3], unused[3][3];
  const double lambda = d->s1.material_properties[0], mu = d->s1.material_properties[1];
  if (request(d) < -0.25 || request(d) > 0.5) return report(d, "no tangent operator"), -1;
  read_tensor(d->s0.gradients, F0);
  read_tensor(d->s1.gradients, F1);
  read_tensor(d->s0.internal_state_variables, Fe0);
  invert(F0, inverse);
  multiply(F1, inverse, increment);
  multiply(increment, Fe0, Fe);
  for (int c = 0; c < 9; ++c) d->s1.internal_state_variables[c] = Fe[row[c]][column[c]];
  const double J = invert(Fe, unused);
  for (int m = 0; m < tridimensional; ++m) {
    const int i = symmetric_row[m], j = symmetric_column[m];
    const double b = Fe[i][0] * Fe[j][0] + Fe[i][1] * Fe[j][1] + Fe[i][2] * Fe[j][2];
    const double stress = (lambda * log(J) * (i == j) + mu * (b - (i == j))) / J;
    d->s1.thermodynamic_forces[m] = shear_factor(m) * stress;
  }
  return 1;
}
