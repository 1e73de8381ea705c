// SPDX-License-Identifier: BSD-3-Clause
// The steps in the middle of a history at which a model is held against differences.
#include "harness/check/specimen.hpp"

#include <algorithm>
#include <functional>

namespace assay::check {

namespace {

/// A deformation by the place 0 .. 1 on the way.
using Way = std::function<Tensor(double s)>;

/// All steps of a history of 1 s from rest.
std::vector<Sample> steps_of(const Specimen& specimen, const Way& F, int steps) {
  std::vector<Sample> all;
  std::vector<double> state = specimen.rest_state();
  for (int k = 0; k < steps; ++k) {
    const auto at = [&](int end) { return F(static_cast<double>(end) / steps); };
    const FailedStep step{k * (1.0 / steps), 1.0 / steps, at(k), at(k + 1), state};
    all.push_back({step, stepped(specimen, step)});
    state = all.back().end.state;
  }
  return all;
}

}  // namespace

std::vector<Sample> samples_of(const Specimen& specimen) {
  const Way F = [&](double s) { return Tensor(specimen.space.turn(1.3 * s) * specimen.stretch(s)); };
  const std::vector<Sample> all = steps_of(specimen, F, specimen.options.effort.quick ? 20 : 60);
  std::vector<Sample> some;
  for (std::size_t k = 3; k < all.size(); k += 7) some.push_back(all[k]);
  return some;
}

std::vector<Sample> samples_beside_histories(const Specimen& specimen) {
  constexpr int steps = 5;
  const double a = specimen.amplitude;
  const Way courses[] = {[](double) { return Tensor(Tensor::Identity()); },
                         [=](double t) { return Tensor(Vector3(1 + a * t, 1 + a * t, 1 - 0.5 * a * t).asDiagonal()); },
                         [&](double t) { return specimen.space.equal_stretches(a * t, false, 0); },
                         [&](double t) { return specimen.space.equal_stretches(a * t, true, 0); },
                         [&](double t) { return specimen.space.stretch(a, std::min(2 * t, 1.0)); }};
  std::vector<Sample> samples;
  for (const Way& F : courses) {
    const std::vector<Sample> all = if_taken([&] { return steps_of(specimen, F, steps); }, {});
    if (!all.empty()) samples.push_back(all.back());
  }
  return samples;
}

}  // namespace assay::check
