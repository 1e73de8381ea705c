// SPDX-License-Identifier: BSD-3-Clause
// MFront's generic behaviour interface, api_version 1: the struct that behaviours take, as its header
// MFront/GenericBehaviour/BehaviourData.h lays it out.
#pragma once

namespace assay::adapters {

struct MfrontState {
  double* gradients;
  double* thermodynamic_forces;
  double* mass_density;
  double* material_properties;
  double* internal_state_variables;
  double* stored_energy;
  double* dissipated_energy;
  double* external_state_variables;
};
static_assert(sizeof(MfrontState) == 64);

struct MfrontData {
  char* error_message;  ///< 512 bytes
  double dt;            ///< of the step
  double* K;            ///< in: what is asked for; out: the operator
  double* rdt;          ///< time step that is proposed over the present one
  double* speed_of_sound;
  MfrontState s0, s1;
};
static_assert(sizeof(MfrontData) == 168);

/// 1: good, 0: unreliable, -1: failed.
using MfrontEntry = int (*)(MfrontData*);
/// 0: not taken.
using MfrontSetParameter = int (*)(const char* name, double value);

}  // namespace assay::adapters
