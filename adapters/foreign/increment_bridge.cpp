// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/increment_bridge.hpp"

#include <algorithm>

#include "adapters/foreign/foreign_library.hpp"
#include "adapters/foreign/kinematics.hpp"

namespace assay::adapters {

Increment increment_of(const ForeignModel& model, const PointStep& step, std::size_t stress, std::size_t strain) {
  Increment increment;
  if (model.axes == Axes::corotational) {
    const CorotationalStep c = corotational_step(step.F0, step.F1, model.kinematics);
    increment.frame = c.R1, increment.strain = c.strain, increment.F0 = c.U0, increment.F1 = c.U1;
  } else {
    const StepStrain of_step = step_strain(step.F0, step.F1, model.kinematics);
    increment.rotation = of_step.rotation, increment.strain = of_step.strain;
    increment.F0 = step.F0, increment.F1 = step.F1;
  }
  const auto carried = [&](std::size_t at) {
    return turned(read_symmetric(step.state0 + at, standard_order, plain_shear), increment.rotation);
  };
  increment.stress = carried(stress), increment.strain_before = carried(strain);
  return increment;
}

Tensor moduli_in_frame(const double* moduli, Components order, const Tensor& frame, const Tensor& strain) {
  double e[6], s[6] = {};
  write_components(turned(strain, frame.transpose()), order, engineering_shear, e);
  for (std::size_t j = 0; j < order.size(); ++j) {
    for (std::size_t i = 0; i < order.size(); ++i) s[i] += *moduli++ * e[j];
  }
  return turned(read_components(s, order, plain_shear), frame);
}

Tensor stress_rate_of_step(const PointStep& step, const Tensor& E, const Tensor& sigma, const ForeignModel& model,
                           const Increment& increment, const std::function<Tensor(const Tensor&)>& moduli_on) {
  const bool turns = model.axes == Axes::corotational;
  const StepStrain rate = turns ? rate_of_corotational_step(step.F0, step.F1, E, model.kinematics)
                                : rate_of_step(step.F0, step.F1, E, model.kinematics);
  const Tensor& R = turns ? increment.frame : increment.rotation;
  const Tensor w = rate.rotation * R.transpose();
  return moduli_on(turned(rate.strain, R)) + w * sigma - sigma * w;
}

/// (1/J) (J sigma)^Jaumann = C : D; that of Truesdell has - D sigma - sigma D beside it.
Tensor stress_rate_by_moduli(const PointStep& step, const Tensor& E, const Tensor& sigma, Moduli moduli,
                             const std::function<Tensor(const Tensor&)>& moduli_on) {
  const Tensor l = E * step.F1.inverse(), D = 0.5 * (l + l.transpose()), w = 0.5 * (l - l.transpose());
  const bool of_tau = moduli == Moduli::jaumann_of_tau || moduli == Moduli::truesdell_of_tau;
  Tensor objective = moduli_on(D) / (of_tau ? step.F1.determinant() : 1);
  if (moduli == Moduli::truesdell || moduli == Moduli::truesdell_of_tau) objective += D * sigma + sigma * D;
  return objective - D.trace() * sigma + w * sigma - sigma * w;
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

void IncrementBridge::call(const PointStep& step) {
  require_served(model_, step.F0, step.F1);
  increment_ = increment_of(model_, step, own_stress, own_strain);
  to_foreign(layout_, model_.state, step.state0 + own_state_, arrays_[state_array()]);
  hand_over(step, increment_);
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
  end.cauchy = turned(found, increment_.frame);
  write_symmetric(found, standard_order, plain_shear, end.state1 + own_stress);
  write_symmetric(increment_.strain_after(), standard_order, plain_shear, end.state1 + own_strain);
  end.state1[own_time] = step.state0[own_time] + step.dt;
  keep_scalars(end.state1 + own_scalars);
  from_foreign(layout_, model_.state, arrays_[state_array()], end.state1 + own_state_);
}

}  // namespace assay::adapters
