/* SPDX-License-Identifier: BSD-3-Clause */
/* Behaviours of MFront's generic interface whose symbols contradict each other. Nobody runs them. */
#include "mfront_behaviour.h"

/* Small strains, no property, no state: what all of them have in common. */
#define WITH_GRADIENT(B, KIND)                   \
  MFRONT_DESCRIPTION(B)                          \
  ARRAY(int, B##_GradientsTypes, 1, KIND)        \
  ARRAY(const char*, B##_Gradients, 1, "Strain") \
  NUMBER(B##_BehaviourType, 1)                   \
  NUMBER(B##_BehaviourKinematic, 1)
#define SMALL_STRAIN(B) WITH_GRADIENT(B, 1)
#define FUNCTION(B)                                      \
  EXPORT int B##_Tridimensional(BehaviourData* const d); \
  int B##_Tridimensional(BehaviourData* const d) { return d ? 1 : -1; }

/* As little as there can be: absent symbols are nothing. */
SMALL_STRAIN(Bare)
FUNCTION(Bare)

SMALL_STRAIN(NoFunction)

/* A count without a list, a list that is null, a list with a hole, and one that is shorter than its count. */
SMALL_STRAIN(NoList)
FUNCTION(NoList)
NUMBER(NoList_nMaterialProperties, 2)
SMALL_STRAIN(NullList)
FUNCTION(NullList)
NUMBER(NullList_nInternalStateVariables, 1)
SYMBOL(const char* const*, NullList_InternalStateVariables, NULL)
SMALL_STRAIN(Hole)
FUNCTION(Hole)
NUMBER(Hole_nMaterialProperties, 2)
ARRAY(const char*, Hole_MaterialProperties, 2, "E", NULL)
SMALL_STRAIN(HugeCount)
FUNCTION(HugeCount)
NUMBER(HugeCount_nInternalStateVariables, 65535)
ARRAY(const char*, HugeCount_InternalStateVariables, 1, "p")
ARRAY(int, HugeCount_InternalStateVariablesTypes, 1, 0)
SMALL_STRAIN(FewTypes)
FUNCTION(FewTypes)
NUMBER(FewTypes_nInternalStateVariables, 3)
ARRAY(const char*, FewTypes_InternalStateVariables, 3, "p", "q", "r")
ARRAY(int, FewTypes_InternalStateVariablesTypes, 1, 0)

SMALL_STRAIN(UnknownKind)
FUNCTION(UnknownKind)
NUMBER(UnknownKind_nInternalStateVariables, 1)
ARRAY(const char*, UnknownKind_InternalStateVariables, 1, "p")
ARRAY(int, UnknownKind_InternalStateVariablesTypes, 1, 7)

SMALL_STRAIN(SameNames)
FUNCTION(SameNames)
NUMBER(SameNames_nInternalStateVariables, 2)
ARRAY(const char*, SameNames_InternalStateVariables, 2, "p", "p")
ARRAY(int, SameNames_InternalStateVariablesTypes, 2, 0, 0)

/* Names that nobody can set. */
SMALL_STRAIN(SameProperties)
FUNCTION(SameProperties)
NUMBER(SameProperties_nMaterialProperties, 2)
ARRAY(const char*, SameProperties_MaterialProperties, 2, "E", "E")
SMALL_STRAIN(NameOfLines)
FUNCTION(NameOfLines)
NUMBER(NameOfLines_nMaterialProperties, 1)
ARRAY(const char*, NameOfLines_MaterialProperties, 1, "E\n=x")
SMALL_STRAIN(NoName)
FUNCTION(NoName)
NUMBER(NoName_nExternalStateVariables, 1)
ARRAY(const char*, NoName_ExternalStateVariables, 1, "")
ARRAY(int, NoName_ExternalStateVariablesTypes, 1, 0)

/* Metadata that contradict each other, or say what there is not. */
WITH_GRADIENT(FullGradient, 3)
FUNCTION(FullGradient)
WITH_GRADIENT(OddGradient, 77)
FUNCTION(OddGradient)
SMALL_STRAIN(FixedPlane)
FUNCTION(FixedPlane)
NUMBER(FixedPlane_nInternalStateVariables, 1)
ARRAY(const char*, FixedPlane_InternalStateVariables, 1, "p")
ARRAY(int, FixedPlane_InternalStateVariablesTypes, 1, 17)
SMALL_STRAIN(OtherHypotheses)
FUNCTION(OtherHypotheses)
NUMBER(OtherHypotheses_Tridimensional_nModellingHypotheses, 1)
SMALL_STRAIN(ManyHypotheses)
FUNCTION(ManyHypotheses)
NUMBER(ManyHypotheses_Tridimensional_nModellingHypotheses, 60000)
SMALL_STRAIN(TwoGradients)
FUNCTION(TwoGradients)
NUMBER(TwoGradients_Tridimensional_nGradients, 2)
ARRAY(int, TwoGradients_Tridimensional_GradientsTypes, 2, 1, 0)
ARRAY(const char*, TwoGradients_Tridimensional_Gradients, 2, "Strain", "Pores")

/* Others than are served. */
TEXT(Cohesive_mfront_ept, "Cohesive")
TEXT(Cohesive_mfront_interface, "Generic")
NUMBER(Cohesive_api_version, 1)
NUMBER(Cohesive_BehaviourType, 3)
NUMBER(Cohesive_BehaviourKinematic, 2)
TEXT(Later_mfront_ept, "Later")
TEXT(Later_mfront_interface, "Generic")
NUMBER(Later_api_version, 2)
TEXT(Castem_mfront_ept, "Castem")
TEXT(Castem_mfront_interface, "Castem")
TEXT(Nothing_mfront_ept, "Nothing")
SYMBOL(const char*, Null_mfront_ept, NULL)
SYMBOL(const char*, Null_mfront_interface, NULL)
