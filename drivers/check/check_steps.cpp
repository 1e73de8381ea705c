// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_steps.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/march.hpp"

namespace assay::drivers {

Answer answer_of(const Material& material, const FailedStep& step, UpdateReport* said) {
  double F0[9], F1[9];
  for (int c = 0; c < 9; ++c) F0[c] = component(step.F0, c), F1[c] = component(step.F1, c);
  Answer answer(state_of_answer + step.state0.size());
  const UpdateReport report = material.update(step.t, step.dt, 1, F0, F1, step.state0.data(),
                                              answer.data() + state_of_answer, answer.data() + stress_of_answer);
  answer[0] = report.worst;
  if (said) *said = report;
  return answer;
}

double largest_stress(const Answer& answer) {
  double largest = 0;
  for (std::size_t c = stress_of_answer; c < state_of_answer; ++c) {
    if (std::isfinite(answer[c])) largest = std::max(largest, std::abs(answer[c]));
  }
  return largest;
}

bool same_answer(const Answer& a, const Answer& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

std::vector<RepeatedStep> repeated_steps(const Material& material, double strain, double pressure, int count) {
  const check::Space space(material);
  const auto F = [&](int k) {
    const double s = static_cast<double>(k) / count;
    return Tensor(space.turn(1.3 * s) * space.stretch(strain, s));
  };
  std::vector<RepeatedStep> steps;
  std::vector<double> state = check::state_at_rest(material, pressure);
  const double dt = 1.0 / count;
  for (int k = 0; k < count; ++k) {
    steps.push_back({{k * dt, dt, F(k), F(k + 1), state}, k == 0});
    const Answer answer = answer_of(material, steps.back());
    if (!is_good(answer)) break;
    state = state_in(answer);
  }
  return steps;
}

}  // namespace assay::drivers
