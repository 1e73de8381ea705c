// SPDX-License-Identifier: BSD-3-Clause
// A behaviour of MFront's generic interface as a model of ours. State of a point: the thermodynamic force at the
// beginning (of finite strains Cauchy's stress; of small strains J R^T sigma R in the frame of the polar rotation R),
// stored and dissipated energy, then the internal variables. Small strains are ln U in that frame.
#pragma once

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "adapters/foreign/written_inputs.hpp"

namespace assay::adapters {

/// MFront's generic behaviour interface, api_version 1: the struct that behaviours take, as its header
/// MFront/GenericBehaviour/BehaviourData.h lays it out.
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

/// Throws ModelRefused.
ForeignVariable::Kind mfront_kind(const MfrontVariable& variable);

class Mfront {
 public:
  static constexpr std::size_t own_state = 8;

  /// What the metadata tells, filled into the model: properties, state, symmetry.
  static void describe(const MfrontBehaviour& behaviour, ForeignModel& model);
  static std::vector<ForeignVariable> state_of(const ForeignModel& model);

  Mfront(const ForeignTable& table, const double* properties);

  void initial_state(const Tensor& cauchy, double* state);
  void update(const PointStep& step, PointEnd& end);
  void tangent(const PointStep& step, double* tangent);

 private:
  struct Arrays {
    std::size_t gradients, forces, density, properties, internal, stored, dissipated, external;
  };
  template <class Add>
  void add_own(Arrays& arrays, const Add& add);
  void add_inputs(Arrays& arrays, const std::string& when);
  void set_parameters();
  void hand_over(const PointStep& step, double request);
  std::int32_t call(double dt);
  Tensor force() const;
  void put_symmetric(const Tensor& A, double* out) const;
  Tensor symmetric_at(const double* in) const;
  void put_gradient(const Tensor& F, double* out) const;
  std::size_t size_of(const std::vector<MfrontVariable>& variables) const;
  /// Of the internal variables of a point, between our state and the behaviour's.
  void give_internal(const double* ours, double* theirs) const;
  void take_internal(const double* theirs, double* ours) const;
  MfrontState pointers(const Arrays& arrays);

  const ForeignTable& table_;
  const ForeignModel& model_;
  const MfrontBehaviour& behaviour_;
  std::vector<double> given_;  ///< all parameters, in declared order
  /// Where the values of properties and external variables come from: a place in given_, or among the varying fields.
  struct Source {
    std::size_t place = 0;
    bool varies = false;
  };
  std::vector<Source> properties_, externals_;
  std::size_t parameters_ = 0;  ///< where those of the library begin in given_
  GuardedArrays arrays_;
  InputWatch inputs_;
  Arrays begin_{}, end_{};
  std::size_t operator_, scalars_;
  Tensor F1_, R1_;
};

}  // namespace assay::adapters
