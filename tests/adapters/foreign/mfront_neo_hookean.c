/* SPDX-License-Identifier: BSD-3-Clause */
/* A library of MFront's generic interface: compressible neo-Hookean elasticity, (34), in finite strain.
 * SPECIALISED: Tridimensional has symbols of its own, the general ones hold for PlaneStrain, which has one more
 * property. COMPONENT_FAULTS: one more property chooses a mistake in the components of the stress. */
#ifdef COMPONENT_FAULTS
#include "component_faults.h"
#endif
#include "mfront_behaviour.h"

MFRONT_DESCRIPTION(NeoHookean)
TEXT(NeoHookean_unit_system, "SI")
ARRAY(int, NeoHookean_GradientsTypes, 1, 3)
ARRAY(const char*, NeoHookean_Gradients, 1, "DeformationGradient")
ARRAY(const char*, NeoHookean_TangentOperatorBlocks, 2, "Stress", "DeformationGradient")
NUMBER(NeoHookean_BehaviourType, 2)
NUMBER(NeoHookean_BehaviourKinematic, 3)

#define OF_HYPOTHESIS(P, COUNT, ...)                                                                            \
  MFRONT_HYPOTHESIS(P)                                                                                          \
  NUMBER(P##_nMaterialProperties, COUNT)                                                                        \
  ARRAY(const char*, P##_MaterialProperties, COUNT, __VA_ARGS__)                                                \
  SYMBOL(long double, P##_YoungModulus_LowerPhysicalBound, 0)                                                   \
  SYMBOL(long double, P##_PoissonRatio_LowerPhysicalBound, -1)                                                  \
  SYMBOL(long double, P##_PoissonRatio_UpperPhysicalBound, 0.5L)                                                \
  NUMBER(P##_nInternalStateVariables, 0)                                                                        \
  SYMBOL(const char* const*, P##_InternalStateVariables, NULL)                                                  \
  SYMBOL(const int*, P##_InternalStateVariablesTypes, NULL)                                                     \
  NUMBER(P##_nParameters, 2)                                                                                    \
  ARRAY(const char*, P##_Parameters, 2, "minimal_time_step_scaling_factor", "maximal_time_step_scaling_factor") \
  ARRAY(int, P##_ParametersTypes, 2, 0, 0)                                                                      \
  NUMBER(P##_requiresStiffnessTensor, 0)                                                                        \
  NUMBER(P##_ComputesDissipatedEnergy, 0)

#ifdef SPECIALISED
OF_HYPOTHESIS(NeoHookean, 3, "YoungModulus", "PoissonRatio", "Thickness")
OF_HYPOTHESIS(NeoHookean_Tridimensional, 2, "YoungModulus", "PoissonRatio")
#elif defined COMPONENT_FAULTS
OF_HYPOTHESIS(NeoHookean, 3, "YoungModulus", "PoissonRatio", "Fault")
#else
OF_HYPOTHESIS(NeoHookean, 2, "YoungModulus", "PoissonRatio")
#endif

static double minimal_factor = 0.1, maximal_factor = DBL_MAX;

EXPORT void NeoHookean_setOutOfBoundsPolicy(const int policy);
EXPORT int NeoHookean_setParameter(const char* const name, const double value);
EXPORT int NeoHookean_Tridimensional(BehaviourData* const d);
EXPORT int NeoHookean_PlaneStrain(BehaviourData* const d);

void NeoHookean_setOutOfBoundsPolicy(const int policy) { (void)policy; }

int NeoHookean_setParameter(const char* const name, const double value) {
  if (strcmp(name, "minimal_time_step_scaling_factor") == 0) return minimal_factor = value, 1;
  if (strcmp(name, "maximal_time_step_scaling_factor") == 0) return maximal_factor = value, 1;
  fprintf(stderr, "NeoHookean: no parameter named '%s'\n", name);
  return 0;
}

/* 11, 22, 33, 12, 21, 13, 31, 23, 32 */
static const int row[9] = {0, 1, 2, 0, 1, 0, 2, 1, 2}, column[9] = {0, 1, 2, 1, 0, 2, 0, 2, 1};

typedef struct {
  double lambda, mu, J, F[3][3], inverse[3][3];
} Point;

static Point point(const double* properties, const double* gradients, int tensor) {
  const double E = properties[0], nu = properties[1];
  Point p = {.lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), .mu = E / (2 * (1 + nu))};
  for (int c = 0; c < tensor; ++c) p.F[row[c]][column[c]] = gradients[c];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) { /* cofactors */
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, e = (j + 2) % 3;
      p.inverse[j][i] = p.F[a][c] * p.F[b][e] - p.F[a][e] * p.F[b][c];
    }
  }
  p.J = p.F[0][0] * p.inverse[0][0] + p.F[0][1] * p.inverse[1][0] + p.F[0][2] * p.inverse[2][0];
  for (int c = 0; c < 9; ++c) p.inverse[row[c]][column[c]] /= p.J;
  return p;
}

static double unit(int i, int j) { return i == j; }
static double b(const Point* p, int i, int j) { /* F F^T */
  return p->F[i][0] * p->F[j][0] + p->F[i][1] * p->F[j][1] + p->F[i][2] * p->F[j][2];
}
static double inverse_C(const Point* p, int i, int j) {
  const double(*G)[3] = p->inverse;
  return G[i][0] * G[j][0] + G[i][1] * G[j][1] + G[i][2] * G[j][2];
}

static double cauchy(const Point* p, int i, int j) {
  return p->lambda * log(p->J) / p->J * unit(i, j) + p->mu / p->J * (b(p, i, j) - unit(i, j));
}
static double pk2(const Point* p, int i, int j) {
  return p->lambda * log(p->J) * inverse_C(p, i, j) + p->mu * (unit(i, j) - inverse_C(p, i, j));
}
static double pk1(const Point* p, int i, int j) {
  return p->mu * p->F[i][j] + (p->lambda * log(p->J) - p->mu) * p->inverse[j][i];
}

/* Derivatives with respect to F_kl. */
static double d_kirchhoff(const Point* p, int i, int j, int k, int l) {
  return p->lambda * unit(i, j) * p->inverse[l][k] + p->mu * (unit(i, k) * p->F[j][l] + unit(j, k) * p->F[i][l]);
}
static double d_cauchy(const Point* p, int i, int j, int k, int l) {
  return d_kirchhoff(p, i, j, k, l) / p->J - cauchy(p, i, j) * p->inverse[l][k];
}
static double d_pk1(const Point* p, int i, int j, int k, int l) {
  const double(*G)[3] = p->inverse;
  return p->lambda * G[j][i] * G[l][k] + p->mu * unit(i, k) * unit(j, l) +
         (p->mu - p->lambda * log(p->J)) * G[j][k] * G[l][i];
}
/* With respect to the Green-Lagrange strain. */
static double d_pk2(const Point* p, int i, int j, int k, int l) {
  return p->lambda * inverse_C(p, i, j) * inverse_C(p, k, l) +
         (p->mu - p->lambda * log(p->J)) *
             (inverse_C(p, i, k) * inverse_C(p, j, l) + inverse_C(p, i, l) * inverse_C(p, j, k));
}

static int option(double value) { return value < 0.5 ? 0 : value < 1.5 ? 1 : value < 2.5 ? 2 : value < 3.5 ? 3 : 4; }

enum { dsig_dF, dS_dE, dP_dF, dtau_ddF };

/* K, row by row; F0 is that of the step's beginning. */
static void write_operator(const Point* p, const Point* start, int which, int symmetric, int tensor, double* K) {
  const int* r = which == dP_dF ? row : symmetric_row;
  const int* c = which == dP_dF ? column : symmetric_column;
  for (int m = 0; m < (which == dP_dF ? tensor : symmetric); ++m) {
    for (int n = 0; n < (which == dS_dE ? symmetric : tensor); ++n, ++K) {
      const int i = r[m], j = c[m], k = row[n], l = column[n];
      switch (which) {
        case dsig_dF:
          *K = shear_factor(m) * d_cauchy(p, i, j, k, l);
          break;
        case dS_dE:
          *K = shear_factor(m) * shear_factor(n) * d_pk2(p, i, j, r[n], c[n]);
          break;
        case dP_dF:
          *K = d_pk1(p, i, j, k, l);
          break;
        default: /* F1 = dF F0 */
          *K = 0;
          for (int q = 0; q < 3; ++q) *K += shear_factor(m) * d_kirchhoff(p, i, j, k, q) * start->F[l][q];
      }
    }
  }
}

static void write_stress(const Point* p, int measure, int symmetric, int tensor, double* out) {
  for (int m = 0; m < (measure == 2 ? tensor : symmetric); ++m) {
    const int i = symmetric_row[m % 6], j = symmetric_column[m % 6];
    out[m] = measure == 2   ? pk1(p, row[m], column[m])
             : measure == 1 ? shear_factor(m) * pk2(p, i, j)
                            : shear_factor(m) * cauchy(p, i, j);
  }
}

static int fail(BehaviourData* d, const char* message) {
  report(d, message);
  *d->rdt = minimal_factor;
  return -1;
}

static int integrate(BehaviourData* d, int symmetric, int tensor) {
  const int measure = option(d->K[1]), which = fabs(d->K[0]) < 0.5 ? dsig_dF : option(d->K[2]);
  const double asked = request(d);
  const int predicts = asked < -0.25;
  if (measure > 2) return report(d, "invalid choice for the stress measure"), -1;
  if (which > dtau_ddF) return report(d, "invalid choice for consistent tangent operator"), -1;
  if (!temperature_is_physical(d)) return fail(d, "Temperature is below its physical lower bound");
  const Point start = point(d->s1.material_properties, d->s0.gradients, tensor);
  const Point p = predicts ? start : point(d->s1.material_properties, d->s1.gradients, tensor);
  if (!(p.J > 0)) return fail(d, "det F <= 0");
  if (wants_speed_of_sound(d)) write_speed_of_sound(d, predicts, p.lambda + 2 * p.mu);
  if (predicts || asked > 0.5) write_operator(&p, &start, which, symmetric, tensor, d->K); /* over the request */
  if (predicts) return 1;
  write_stress(&p, measure, symmetric, tensor, d->s1.thermodynamic_forces);
#ifdef COMPONENT_FAULTS
  if (measure != 0 || symmetric != tridimensional) return report(d, "the Cauchy stress alone can be wrong"), -1;
  plant_fault((enum component_fault)d->s1.material_properties[2], d->s1.thermodynamic_forces);
#endif
  const double trace_b = b(&p, 0, 0) + b(&p, 1, 1) + b(&p, 2, 2), ln_J = log(p.J);
  *d->s1.stored_energy = p.lambda / 2 * ln_J * ln_J - p.mu * ln_J + p.mu / 2 * (trace_b - 3);
  *d->rdt = fmin(*d->rdt, maximal_factor);
  return *d->rdt < 0.99 ? 0 : 1;
}

int NeoHookean_Tridimensional(BehaviourData* const d) { return integrate(d, tridimensional, 9); }

int NeoHookean_PlaneStrain(BehaviourData* const d) { return integrate(d, plane_strain, 5); }
