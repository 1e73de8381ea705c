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

/// Of one step, in units of SI and in the axes of the model. Where these turn with the body, F0 and F1 are stretches.
struct Increment {
  Tensor stress, strain_before, strain, F0, F1;
  Tensor frame = Tensor::Identity();     ///< axes of the model at the end of the step
  Tensor rotation = Tensor::Identity();  ///< of the step, where the axes are those of space

  Tensor strain_after() const { return strain_before + strain; }
};

/// stress, strain: where they begin in the state of a point.
Increment increment_of(const ForeignModel& model, const PointStep& step, std::size_t stress, std::size_t strain);

inline Tensor turned(const Tensor& A, const Tensor& R) { return R * A * R.transpose(); }

/// What moduli, column by column in axes of a frame, make of a strain in those of space.
Tensor moduli_in_frame(const double* moduli, Components order, const Tensor& frame, const Tensor& strain);

/// d sigma along dF1 = E where the stress turns with the step, or with the frame: of moduli d stress / d strain
/// increment in these axes. moduli_on: of a strain, in the axes of space.
Tensor stress_rate_of_step(const PointStep& step, const Tensor& E, const Tensor& sigma, const ForeignModel& model,
                           const Increment& increment, const std::function<Tensor(const Tensor&)>& moduli_on);

/// The same where moduli give a rate of J sigma, over J, or one of tau (foreign_model.hpp), in any axes.
Tensor stress_rate_by_moduli(const PointStep& step, const Tensor& E, const Tensor& sigma, Moduli moduli,
                             const std::function<Tensor(const Tensor&)>& moduli_on);

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
  double age_of(const PointStep& step) const { return step.state0[own_time]; }
  const double* scalars_of(const PointStep& step) const { return step.state0 + own_scalars; }

  static constexpr std::size_t own_stress = 0, own_strain = 6, own_time = 12, own_scalars = 13;
  StateLayout layout_;
  std::size_t own_state_;  ///< of a point, before that of the model
  GuardedArrays arrays_;
  InputWatch inputs_;
  Increment increment_;  ///< of the last call

 private:
  std::string words_;
  const char* state_name_;
};

}  // namespace assay::adapters
