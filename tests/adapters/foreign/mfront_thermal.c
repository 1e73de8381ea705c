/* SPDX-License-Identifier: BSD-3-Clause */
/* A behaviour of MFront's generic interface that expands with Temperature and Swelling. */
#include "mfront_behaviour.h"
#include "thermal_law.h"

MFRONT_DESCRIPTION(Thermal)
ARRAY(int, Thermal_GradientsTypes, 1, 1)
ARRAY(const char*, Thermal_Gradients, 1, "Strain")
NUMBER(Thermal_BehaviourType, 1)
NUMBER(Thermal_BehaviourKinematic, 1)
NUMBER(Thermal_nMaterialProperties, 3)
ARRAY(const char*, Thermal_MaterialProperties, 3, "YoungModulus", "PoissonRatio", "Expansion")
NUMBER(Thermal_nInternalStateVariables, 2)
ARRAY(const char*, Thermal_InternalStateVariables, 2, "warm", "swollen")
ARRAY(int, Thermal_InternalStateVariablesTypes, 2, 0, 0)
NUMBER(Thermal_nExternalStateVariables, 1)
ARRAY(const char*, Thermal_ExternalStateVariables, 1, "Swelling")
ARRAY(int, Thermal_ExternalStateVariablesTypes, 1, 0)

EXPORT int Thermal_Tridimensional(BehaviourData* const d);
int Thermal_Tridimensional(BehaviourData* const d) {
  const double root2 = sqrt(2);
  const double *before = d->s0.external_state_variables, *after = d->s1.external_state_variables;
  double increment[6];
  for (int i = 0; i < 6; ++i) increment[i] = (d->s1.gradients[i] - d->s0.gradients[i]) / (i < 3 ? 1 : root2);
  for (int i = 0; i < 6; ++i)
    d->s1.thermodynamic_forces[i] = d->s0.thermodynamic_forces[i] +
                                    (i < 3 ? 1 : root2) * thermal_stress(d->s1.material_properties, increment,
                                                                         after[0] - before[0], after[1] - before[1], i);
  d->s1.internal_state_variables[0] = after[0];
  d->s1.internal_state_variables[1] = after[1];
  return 1;
}
