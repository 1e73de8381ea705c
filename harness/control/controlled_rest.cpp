// SPDX-License-Identifier: BSD-3-Clause
// A point at rest: its state, its stiffness, and the smallest increment that the model answers.
#include <algorithm>
#include <cmath>

#include "harness/control/controlled_step.hpp"
#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

constexpr double least_rounding = 1e-12, largest_rounding = 1e-6;  ///< of a material, in strains
constexpr double roughness_margin = 10;                            ///< of what second differences show
constexpr double step_at_rest = 1e-6;                              ///< of q, at rest
constexpr double usual_least_difference = 1e-11;                   ///< of q
constexpr double deaf = 0.5;         ///< of the stiffness at rest: an increment that a model answers with less
constexpr double heard_again = 100;  ///< times such an increment: one that it answers

}  // namespace

ControlledSteps::ControlledSteps(const Material& material, const Control& control)
    : material_(material), control_(control), free_(control), least_difference_(usual_least_difference) {
  for (std::size_t k = 0; k < control.rows.size(); ++k) {
    if (!control.rows[k].is_linear_in_q()) solved_rows_.push_back(k);
  }
  if (static_cast<int>(solved_rows_.size()) != free_.count()) {
    throw ControlError("there are " + std::to_string(control.rows.size()) + " rows for " +
                           std::to_string(control.unknowns()) + " components of the deformation",
                       -1);
  }
  const ControlledPoint rest = at_rest();
  const double dt = 1e-6 * control.length();
  double largest = 0, roughest = 0;
  for (int c = 0; c < 9; ++c) {
    if (!material.takes(c)) continue;
    const auto moved = [&](double by) {
      Tensor q = rest.q;
      component(q, c) += by;
      if (control.deformation == Deformation::logarithmic_strain) q = Tensor(0.5 * (q + q.transpose()));
      auto found = end(rest, dt, q);
      if (!found) throw *failure_;
      return *std::move(found);
    };
    const ControlledPoint once = moved(step_at_rest), twice = moved(2 * step_at_rest);
    largest = std::max(largest, largest_of(once.s - rest.s) / step_at_rest);
    roughest = std::max(roughest, largest_of(twice.s - 2 * once.s + rest.s));
    state_moduli_.resize(rest.state.size());
    for (std::size_t k = 0; k < rest.state.size(); ++k)
      state_moduli_[k] = std::max(state_moduli_[k], std::abs(once.state[k] - rest.state[k]) / step_at_rest);
  }
  if (largest > 0) modulus_ = largest;
  rounding_ = std::clamp(roughness_margin * roughest / modulus_, least_rounding, largest_rounding);
  find_grain(rest, dt);
}

/// A model that solves equations of its own to a tolerance answers no smaller increment.
void ControlledSteps::find_grain(const ControlledPoint& rest, double dt) {
  Tensor along = Tensor::Zero();
  along(0, 0) = 1;
  const auto stiffness = [&](double by) {
    const auto found = end(rest, dt, rest.q + by * along);
    return found ? largest_of(found->s - rest.s) / by : 0;
  };
  const double usual = stiffness(step_at_rest);
  double grain = 0;
  for (double by = usual_least_difference; by < 0.5 * step_at_rest && stiffness(by) < deaf * usual; by *= 10)
    grain = by;
  if (grain == 0) return;
  least_difference_ = heard_again * grain;
  rounding_ = std::clamp(grain, rounding_, largest_rounding);
}

ControlledPoint point_at_rest(const Material& material, const Control& control) {
  if (control.start) return *control.start;
  ControlledPoint rest;
  rest.t = control.begin();
  rest.q = deformation_at_rest(control.deformation);
  rest.s = control.initial_cauchy;
  const bool stressed = !control.initial_cauchy.isZero(0);
  const auto nine = nine_of(control.initial_cauchy);
  rest.state = material.initial_state(1, stressed ? std::span<const double>(nine) : std::span<const double>());
  return rest;
}

}  // namespace assay
