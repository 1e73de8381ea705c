// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/increment_bridge.hpp"

#include <algorithm>

#include "adapters/foreign/foreign_library.hpp"
#include "adapters/foreign/kinematics.hpp"

namespace assay::adapters {

Tensor stress_rate_of_step(const PointStep& step, const Tensor& E, const Tensor& sigma, Kinematics kinematics,
                           bool turns, const Tensor& R, const std::function<Tensor(const Tensor&)>& moduli_on) {
  const StepStrain rate = turns ? rate_of_corotational_step(step.F0, step.F1, E, kinematics)
                                : rate_of_step(step.F0, step.F1, E, kinematics);
  const Tensor w = rate.rotation * R.transpose();
  return moduli_on(R * rate.strain * R.transpose()) + w * sigma - sigma * w;
}

std::vector<ForeignVariable> IncrementBridge::state_with(const ForeignModel& model,
                                                         const std::vector<ForeignVariable>& scalars) {
  using Kind = ForeignVariable::Kind;
  const bool turning = model.axes == Axes::corotational;
  const char* axes = turning ? "; in axes that turn with the body" : "; rotated by the host";
  std::vector<ForeignVariable> all{{"STRESS", Kind::symmetric_tensor, "Pa", std::string("Cauchy") + axes, {}},
                                   {"STRAIN", Kind::symmetric_tensor, "1", std::string("plain shears") + axes, {}},
                                   {"TIME", Kind::scalar, "s", "since the beginning of the point", {}}};
  all.insert(all.end(), scalars.begin(), scalars.end());
  all.insert(all.end(), model.state.begin(), model.state.end());
  return all;
}

IncrementBridge::IncrementBridge(const ForeignTable& table, const double* properties, const StateLayout& layout,
                                 std::string words, const char* state_name, std::size_t scalars)
    : AbaqusBridge(table, properties),
      layout_(layout),
      own_state_(own_scalars + scalars),
      words_(std::move(words)),
      state_name_(state_name) {}

void IncrementBridge::make_arrays(std::size_t fence) {
  arrays_ = GuardedArrays(fence);
  inputs_ = InputWatch();
  add_arrays();
  hold(host_);
}

void IncrementBridge::hold(const HostValues& values) {
  host_ = values;
  fill_once();
  inputs_.forget();
}

void IncrementBridge::initial_state(const Tensor& cauchy, double* state) {
  std::fill_n(state, own_state_, 0.0);
  write_symmetric(cauchy, standard_order, plain_shear, state + own_stress);
  write_initial(model_.state, state + own_state_);
}

IncrementBridge::Increment IncrementBridge::increment_of(const PointStep& step) {
  Increment increment;
  increment.F0 = step.F0, increment.F1 = step.F1;
  if (turns()) {
    const CorotationalStep c = corotational_step(step.F0, step.F1, model_.kinematics);
    frame_ = c.R1, increment.strain = c.strain;
  } else {
    const StepStrain turned = step_strain(step.F0, step.F1, model_.kinematics);
    rotation_ = turned.rotation, increment.strain = turned.strain;
  }
  const auto carried = [&](std::size_t at) {
    const Tensor own = read_symmetric(step.state0 + at, standard_order, plain_shear);
    return Tensor(rotation_ * own * rotation_.transpose());
  };
  increment.stress = carried(own_stress), increment.strain_before = carried(own_strain);
  increment.age = step.state0[own_time];
  strain_after_ = increment.strain_before + increment.strain;
  return increment;
}

void IncrementBridge::call(const PointStep& step) {
  require_served(model_, step.F0, step.F1);
  const Increment increment = increment_of(step);
  to_foreign(layout_, model_.state, step.state0 + own_state_, arrays_[state_array()]);
  hand_over(step, increment);
  inputs_.keep(arrays_);
  if (surroundings_.lent()) surroundings_.lend(arrays_);
  probe_.lend(arrays_);
  const auto ended = ended_in([this] { call_entry(); });
  probe_.take_back(arrays_);
  if (surroundings_.lent()) surroundings_.take_back(arrays_);
  const auto broken = inputs_.broken_fence(arrays_);
  if (ended) throw PointFailure(words_ + " " + *ended);
  if (broken) throw PointFailure(overrun_words + words_ + " " + *broken);
  require_good();
}

void IncrementBridge::update(const PointStep& step, PointEnd& end) {
  call(step);
  if (probe_.is_due()) probe_.look(arrays_, {stress_array(), state_array()}, state_name_, [&] { call(step); });
  const Tensor found = stress();
  end.cauchy = frame_ * found * frame_.transpose();
  write_symmetric(found, standard_order, plain_shear, end.state1 + own_stress);
  write_symmetric(strain_after_, standard_order, plain_shear, end.state1 + own_strain);
  end.state1[own_time] = step.state0[own_time] + step.dt;
  keep_scalars(end.state1 + own_scalars);
  from_foreign(layout_, model_.state, arrays_[state_array()], end.state1 + own_state_);
}

}  // namespace assay::adapters
