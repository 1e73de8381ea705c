/* SPDX-License-Identifier: BSD-3-Clause */
/* A library of MFront's generic interface: Norton's creep in small strain, d p / dt = A q^n, theta method.
 * The stiffness is required: E and nu come before the properties listed, of which there are none. */
#include "mfront_behaviour.h"

MFRONT_DESCRIPTION(Norton)
TEXT(Norton_unit_system, "")
ARRAY(int, Norton_GradientsTypes, 1, 1)
ARRAY(const char*, Norton_Gradients, 1, "Strain")
ARRAY(const char*, Norton_TangentOperatorBlocks, 2, "Stress", "Strain")
NUMBER(Norton_BehaviourType, 1)
NUMBER(Norton_BehaviourKinematic, 1)
MFRONT_HYPOTHESIS(Norton)
NUMBER(Norton_nMaterialProperties, 0)
SYMBOL(const char* const*, Norton_MaterialProperties, NULL)
NUMBER(Norton_nInternalStateVariables, 2)
ARRAY(const char*, Norton_InternalStateVariables, 2, "ElasticStrain", "EquivalentViscoplasticStrain")
ARRAY(int, Norton_InternalStateVariablesTypes, 2, 1, 0)
NUMBER(Norton_nParameters, 7)
ARRAY(const char*, Norton_Parameters, 7, "A", "n", "minimal_time_step_scaling_factor",
      "maximal_time_step_scaling_factor", "epsilon", "theta", "iterMax")
ARRAY(int, Norton_ParametersTypes, 7, 0, 0, 0, 0, 0, 0, 2)
SYMBOL(double, Norton_A_ParameterDefaultValue, 8e-67)
SYMBOL(double, Norton_n_ParameterDefaultValue, 8.2)
SYMBOL(double, Norton_epsilon_ParameterDefaultValue, 1e-14)
SYMBOL(double, Norton_theta_ParameterDefaultValue, 1)
SYMBOL(unsigned short, Norton_iterMax_ParameterDefaultValue, 100)
NUMBER(Norton_requiresStiffnessTensor, 1)
NUMBER(Norton_ComputesDissipatedEnergy, 1)

EXPORT void Norton_setOutOfBoundsPolicy(const int policy);
EXPORT int Norton_setParameter(const char* const name, const double value);
EXPORT int Norton_setUnsignedShortParameter(const char* const name, const unsigned short value);
EXPORT int Norton_Tridimensional(BehaviourData* const d);
EXPORT int Norton_PlaneStrain(BehaviourData* const d);

enum { A, n, minimal_factor, maximal_factor, epsilon, theta, parameter_count };
static double parameter[parameter_count] = {8e-67, 8.2, 0.1, DBL_MAX, 1e-14, 1};
static unsigned short iterations = 100;

void Norton_setOutOfBoundsPolicy(const int policy) { (void)policy; }

int Norton_setParameter(const char* const name, const double value) {
  for (int i = 0; i < parameter_count; ++i) {
    if (strcmp(name, Norton_Parameters[i]) == 0) return parameter[i] = value, 1;
  }
  fprintf(stderr, "Norton: no parameter named '%s'\n", name);
  return 0;
}

int Norton_setUnsignedShortParameter(const char* const name, const unsigned short value) {
  if (strcmp(name, "iterMax") == 0) return iterations = value, 1;
  fprintf(stderr, "Norton: no parameter named '%s'\n", name);
  return 0;
}

static const double largest_increment = 0.1; /* of strain */

/* Root of dp = dt A (q - 3 theta mu dp)^n, approached from below; negative where it is not found. */
static double creep_increment(double q, double mu, double dt) {
  double dp = 0;
  for (int k = 0; k < iterations; ++k) {
    const double left = fmax(q - 3 * parameter[theta] * mu * dp, 0);
    const double rate = parameter[A] * pow(left, parameter[n]);
    const double slope = left > 0 ? parameter[n] * rate / left : 0;
    const double change = (dt * rate - dp) / (1 + 3 * parameter[theta] * mu * dt * slope);
    if (!isfinite(change)) return -1;
    dp = fmax(dp + change, 0);
    if (fabs(change) < parameter[epsilon]) return dp;
  }
  return -1;
}

typedef struct {
  double lambda, mu, q, q_relaxed, dp, direction[6]; /* Mises stress, before and after creep; d q / d sigma */
} Flow;

static Flow flow(const BehaviourData* d, int size, const double* increment) {
  const double E = d->s1.material_properties[0], nu = d->s1.material_properties[1];
  Flow f = {.lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), .mu = E / (2 * (1 + nu))};
  double e[6] = {0}, square = 0;
  for (int i = 0; i < size; ++i) e[i] = d->s0.internal_state_variables[i] + parameter[theta] * increment[i];
  const double mean = (e[0] + e[1] + e[2]) / 3;
  for (int i = 0; i < size; ++i) {
    f.direction[i] = 2 * f.mu * (i < 3 ? e[i] - mean : e[i]);
    square += f.direction[i] * f.direction[i];
  }
  f.q = sqrt(1.5 * square);
  for (int i = 0; i < size; ++i) f.direction[i] = f.q > 0 ? 1.5 * f.direction[i] / f.q : 0;
  f.dp = creep_increment(f.q, f.mu, d->dt);
  f.q_relaxed = f.q - 3 * parameter[theta] * f.mu * f.dp;
  return f;
}

static double deviator(int i, int j) { return (i == j) - (i < 3 && j < 3 ? 1.0 / 3 : 0); }

/* Elastic, or consistent with the step; row by row. */
static void write_operator(const Flow* f, double dt, int consistent, int size, double* K) {
  const double slope = f->q_relaxed > 0 ? dt * parameter[A] * parameter[n] * pow(f->q_relaxed, parameter[n] - 1) : 0;
  const double of_p = slope / (1 + 3 * parameter[theta] * f->mu * slope), of_direction = f->q > 0 ? f->dp / f->q : 0;
  const double factor = consistent ? 4 * f->mu * f->mu * parameter[theta] : 0;
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const double N = f->direction[i] * f->direction[j];
      K[i * size + j] = (i < 3 && j < 3 ? f->lambda : 0) + (i == j ? 2 * f->mu : 0) -
                        factor * (of_p * N + of_direction * (1.5 * deviator(i, j) - N));
    }
  }
}

static void write_state(const BehaviourData* d, const Flow* f, int size, const double* increment) {
  double* end = d->s1.internal_state_variables;
  for (int i = 0; i < size; ++i) {
    end[i] = d->s0.internal_state_variables[i] + increment[i] - f->dp * f->direction[i];
  }
  end[size] = d->s0.internal_state_variables[size] + f->dp;
  const double trace = end[0] + end[1] + end[2];
  double energy = 0;
  for (int i = 0; i < size; ++i) {
    d->s1.thermodynamic_forces[i] = (i < 3 ? f->lambda * trace : 0) + 2 * f->mu * end[i];
    energy += d->s1.thermodynamic_forces[i] * end[i] / 2;
  }
  *d->s1.stored_energy = energy;
  *d->s1.dissipated_energy = *d->s0.dissipated_energy + f->q_relaxed * f->dp;
}

static int fail(const BehaviourData* d) {
  *d->rdt = parameter[minimal_factor];
  return -1;
}

static int integrate(BehaviourData* d, int size) {
  const double asked = request(d);
  double increment[6], square = 0;
  for (int i = 0; i < size; ++i) {
    increment[i] = asked < -0.25 ? 0 : d->s1.gradients[i] - d->s0.gradients[i];
    square += increment[i] * increment[i];
  }
  if (!temperature_is_physical(d)) return report(d, "Temperature is below its physical lower bound"), fail(d);
  if (!(sqrt(square) <= largest_increment)) return fail(d);
  const Flow f = flow(d, size, increment);
  if (wants_speed_of_sound(d)) write_speed_of_sound(d, asked < -0.25, f.lambda + 2 * f.mu);
  if (asked < -0.25) return write_operator(&f, d->dt, 0, size, d->K), 1;
  if (f.dp < 0) return fail(d);
  write_state(d, &f, size, increment);
#ifdef WRITES_ITS_BEGINNING
  ((double*)d->s0.internal_state_variables)[size] = d->s1.internal_state_variables[size];
#endif
  if (asked > 0.5) write_operator(&f, d->dt, asked > 2.5, size, d->K);
  *d->rdt = fmin(*d->rdt, parameter[maximal_factor]);
  return *d->rdt < 0.99 ? 0 : 1;
}

int Norton_Tridimensional(BehaviourData* const d) { return integrate(d, tridimensional); }

int Norton_PlaneStrain(BehaviourData* const d) { return integrate(d, plane_strain); }
