// SPDX-License-Identifier: BSD-3-Clause
// What interfaces that take one point and its strain increment have in common, Ansys' USERMAT and LS-DYNA's umat41 to
// umat50. State of a point: stress [Pa] and strain (plain shears) as the host carries them on, the time since the
// point's beginning [s], scalars of the interface, then the state as declared.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/host_values.hpp"
#include "adapters/foreign/written_inputs.hpp"

namespace assay::adapters {

/// d sigma along dF1 = E where the stress turns with the step, or with the frame of R: of moduli d stress / d strain
/// increment in these axes. R: rotation of the step, or frame at its end. moduli_on: of a strain, in the axes of space.
Tensor stress_rate_of_step(const PointStep& step, const Tensor& E, const Tensor& sigma, Kinematics kinematics,
                           bool turns, const Tensor& R, const std::function<Tensor(const Tensor&)>& moduli_on);

class IncrementBridge : public AbaqusBridge {
 public:
  void initial_state(const Tensor& cauchy, double* state);
  void update(const PointStep& step, PointEnd& end);  ///< Throws PointFailure.

  void hold(const HostValues& values) override;
  void widen() override { make_arrays(GuardedArrays::widest_fence); }
  const GuardedArrays& arrays_of_a_point() override { return arrays_; }

 protected:
  /// What all have, with scalars of J/m^3 or 1 in their places.
  static std::vector<ForeignVariable> state_with(const ForeignModel& model,
                                                 const std::vector<ForeignVariable>& scalars);

  /// words: "the USERMAT"; state_name: of the array of the state, for messages. scalars: of the interface, in a point.
  IncrementBridge(const ForeignTable& table, const double* properties, const StateLayout& layout, std::string words,
                  const char* state_name, std::size_t scalars);

  /// Of one call, in units of SI and in the axes of the model.
  struct Increment {
    Tensor stress, strain_before, strain, F0, F1;
    double age = 0;
  };

  void make_arrays(std::size_t fence);  ///< to be called when the derived class is made
  virtual void add_arrays() = 0;        ///< outputs, then inputs behind inputs_.begin
  virtual void fill_once() = 0;         ///< what does not change from call to call
  virtual void hand_over(const PointStep& step, const Increment& increment) = 0;
  virtual void call_entry() = 0;
  virtual void require_good() const {}  ///< Throws PointFailure where the model refuses.
  virtual Tensor stress() const = 0;    ///< in the axes of the model [Pa]
  virtual std::size_t stress_array() const = 0;
  virtual std::size_t state_array() const = 0;
  virtual void keep_scalars(double* scalars) const = 0;

  void call(const PointStep& step);
  bool turns() const { return model_.axes == Axes::corotational; }
  const double* scalars_of(const PointStep& step) const { return step.state0 + own_scalars; }

  static constexpr std::size_t own_stress = 0, own_strain = 6, own_time = 12, own_scalars = 13;
  StateLayout layout_;
  std::size_t own_state_;  ///< of a point, before that of the model
  GuardedArrays arrays_;
  InputWatch inputs_;
  Tensor frame_ = Tensor::Identity();     ///< axes of the model at the end of the step
  Tensor rotation_ = Tensor::Identity();  ///< of the step, where the axes are those of space

 private:
  Increment increment_of(const PointStep& step);

  std::string words_;
  const char* state_name_;
  Tensor strain_after_ = Tensor::Zero();
};

}  // namespace assay::adapters
