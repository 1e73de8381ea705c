/* SPDX-License-Identifier: BSD-3-Clause */
/* Behaviours of MFront's generic interface in small strain: one writes no force, one returns what its property says,
 * one has the temperature among its own external variables, one takes none, and one takes no parameter. */
#include "mfront_behaviour.h"

#define SMALL_STRAIN(B, PROPERTY)                   \
  MFRONT_DESCRIPTION(B)                             \
  ARRAY(int, B##_GradientsTypes, 1, 1)              \
  ARRAY(const char*, B##_Gradients, 1, "Strain")    \
  NUMBER(B##_BehaviourType, 1)                      \
  NUMBER(B##_BehaviourKinematic, 1)                 \
  NUMBER(B##_nMaterialProperties, 1)                \
  ARRAY(const char*, B##_MaterialProperties, 1, PROPERTY) \
  EXPORT int B##_Tridimensional(BehaviourData* const d);

/* Without coupling of the axes. */
static void write_force(const BehaviourData* d, double modulus) {
  for (int m = 0; m < tridimensional; ++m) d->s1.thermodynamic_forces[m] = modulus * d->s1.gradients[m];
}

SMALL_STRAIN(Silent, "YoungModulus")
int Silent_Tridimensional(BehaviourData* const d) { return d ? 1 : -1; }

SMALL_STRAIN(Returns, "status")
int Returns_Tridimensional(BehaviourData* const d) {
  write_force(d, 1e3);
  return (int)d->s1.material_properties[0];
}

SMALL_STRAIN(Warm, "YoungModulus")
NUMBER(Warm_nExternalStateVariables, 1)
ARRAY(const char*, Warm_ExternalStateVariables, 1, "Temperature")
ARRAY(int, Warm_ExternalStateVariablesTypes, 1, 0)
NUMBER(Warm_Tridimensional_TemperatureRemovedFromExternalStateVariables, 0)
int Warm_Tridimensional(BehaviourData* const d) {
  write_force(d, d->s1.material_properties[0] * d->s1.external_state_variables[0]);
  return 1;
}

SMALL_STRAIN(Cold, "YoungModulus")
NUMBER(Cold_Tridimensional_TemperatureRemovedFromExternalStateVariables, 0)
int Cold_Tridimensional(BehaviourData* const d) {
  write_force(d, d->s1.material_properties[0]);
  return 1;
}

SMALL_STRAIN(Deaf, "YoungModulus")
NUMBER(Deaf_nParameters, 1)
ARRAY(const char*, Deaf_Parameters, 1, "theta")
ARRAY(int, Deaf_ParametersTypes, 1, 0)
SYMBOL(double, Deaf_theta_ParameterDefaultValue, 1)
EXPORT int Deaf_setParameter(const char* const name, const double value);
int Deaf_setParameter(const char* const name, const double value) { return name == NULL && value > 0; }
int Deaf_Tridimensional(BehaviourData* const d) {
  write_force(d, d->s1.material_properties[0]);
  return 1;
}
