/* SPDX-License-Identifier: BSD-3-Clause */
/* MFront's generic interface (API version 1) as a generated library sees it: its structures and its symbols. */
#ifndef ASSAY_TEST_MFRONT_BEHAVIOUR_H
#define ASSAY_TEST_MFRONT_BEHAVIOUR_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

typedef struct {
  const double* gradients;
  const double* thermodynamic_forces;
  const double* mass_density;
  const double* material_properties;
  const double* internal_state_variables;
  const double* stored_energy;
  const double* dissipated_energy;
  const double* external_state_variables;
} InitialState;

typedef struct {
  const double* gradients;
  double* thermodynamic_forces;
  const double* mass_density;
  const double* material_properties;
  double* internal_state_variables;
  double* stored_energy;
  double* dissipated_energy;
  const double* external_state_variables;
} State;

typedef struct {
  char* error_message; /* null or 512 characters */
  double dt;
  double* K;
  double* rdt;
  double* speed_of_sound;
  InitialState s0;
  State s1;
} BehaviourData;

/* Symbols are variables, none of them const. A list without members is a null pointer, not an array. */
#define EXPORT __attribute__((visibility("default")))
#define SYMBOL(TYPE, NAME, VALUE) \
  EXPORT extern TYPE NAME;        \
  TYPE NAME = VALUE;
#define ARRAY(TYPE, NAME, SIZE, ...) \
  EXPORT extern TYPE NAME[SIZE];     \
  TYPE NAME[SIZE] = {__VA_ARGS__};
#define TEXT(NAME, VALUE) SYMBOL(const char*, NAME, VALUE)
#define NUMBER(NAME, VALUE) SYMBOL(unsigned short, NAME, VALUE)

/* What every behaviour says in the same words. */
#define MFRONT_DESCRIPTION(B)                                                     \
  TEXT(B##_author, "")                                                            \
  TEXT(B##_date, "")                                                              \
  TEXT(B##_description, "")                                                       \
  TEXT(B##_validator, "")                                                         \
  TEXT(B##_build_id, "")                                                          \
  TEXT(B##_mfront_ept, #B)                                                        \
  TEXT(B##_tfel_version, "5.2.0-dev")                                             \
  NUMBER(B##_mfront_mkt, 1)                                                       \
  TEXT(B##_mfront_interface, "Generic")                                           \
  TEXT(B##_src, #B ".mfront")                                                     \
  NUMBER(B##_nModellingHypotheses, 2)                                             \
  ARRAY(const char*, B##_ModellingHypotheses, 2, "PlaneStrain", "Tridimensional") \
  NUMBER(B##_nMainVariables, 1)                                                   \
  NUMBER(B##_nGradients, 1)                                                       \
  NUMBER(B##_nThermodynamicForces, 1)                                             \
  ARRAY(int, B##_ThermodynamicForcesTypes, 1, 1)                                  \
  ARRAY(const char*, B##_ThermodynamicForces, 1, "Stress")                        \
  NUMBER(B##_nTangentOperatorBlocks, 2)                                           \
  NUMBER(B##_SymmetryType, 0)                                                     \
  NUMBER(B##_ElasticSymmetryType, 0)                                              \
  NUMBER(B##_api_version, 1)                                                      \
  NUMBER(B##_TemperatureRemovedFromExternalStateVariables, 1)

/* The same for P = behaviour, or behaviour_hypothesis where the hypothesis is special. */
#define MFRONT_HYPOTHESIS(P)                                                                       \
  NUMBER(P##_UsableInPurelyImplicitResolution, 1)                                                  \
  NUMBER(P##_nExternalStateVariables, 0)                                                           \
  SYMBOL(const char* const*, P##_ExternalStateVariables, NULL)                                     \
  SYMBOL(const int*, P##_ExternalStateVariablesTypes, NULL)                                        \
  SYMBOL(double, P##_minimal_time_step_scaling_factor_ParameterDefaultValue, 0.1)                  \
  SYMBOL(double, P##_maximal_time_step_scaling_factor_ParameterDefaultValue, 1.7976931348623e+308) \
  SYMBOL(long double, P##_Temperature_LowerPhysicalBound, 0)                                       \
  NUMBER(P##_requiresThermalExpansionCoefficientTensor, 0)                                         \
  NUMBER(P##_nInitializeFunctions, 0)                                                              \
  SYMBOL(const char* const*, P##_InitializeFunctions, NULL)                                        \
  NUMBER(P##_nPostProcessings, 0)                                                                  \
  SYMBOL(const char* const*, P##_PostProcessings, NULL)                                            \
  NUMBER(P##_ComputesInternalEnergy, 1)

enum { tridimensional = 6, plane_strain = 4 }; /* components of a symmetric tensor */

/* 11, 22, 33, 12, 13, 23, shears times sqrt(2) */
static const int symmetric_row[6] = {0, 1, 2, 0, 0, 1}, symmetric_column[6] = {0, 1, 2, 1, 2, 2};

static inline double shear_factor(int component) { return component < 3 ? 1 : sqrt(2); }

static inline void report(const BehaviourData* d, const char* message) {
  if (d->error_message) snprintf(d->error_message, 512, "%s", message);
}

/* Computation asked for by K[0], without the speed of sound. */
static inline int wants_speed_of_sound(const BehaviourData* d) { return d->K[0] > 50; }
static inline double request(const BehaviourData* d) { return d->K[0] - (wants_speed_of_sound(d) ? 100 : 0); }

static inline void write_speed_of_sound(const BehaviourData* d, int predicts, double modulus) {
  *d->speed_of_sound = sqrt(modulus / *(predicts ? d->s0.mass_density : d->s1.mass_density));
}

/* Temperature is the first external variable, at both ends of the step. */
static inline int temperature_is_physical(const BehaviourData* d) {
  return d->s0.external_state_variables[0] >= 0 && d->s1.external_state_variables[0] >= 0;
}

#endif
