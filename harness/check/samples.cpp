// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/samples.hpp"

#include <algorithm>

#include "harness/check/repeated_stretch.hpp"

namespace assay::check {

std::vector<Sample> samples_of(const Specimen& specimen) {
  const Material& material = *specimen.material;
  const int steps = specimen.options.effort.quick ? 20 : 60;
  const auto F = [&](int k) {
    const double s = static_cast<double>(k) / steps;
    return Tensor(specimen.space.turn(1.3 * s) * specimen.space.stretch(specimen.amplitude, s));
  };
  std::vector<Sample> samples;
  Point now{Tensor::Zero(), specimen.rest_state()};
  for (int k = 0; k < steps; ++k) {
    const double dt = 1.0 / steps;
    Sample sample{k * dt, dt, F(k), F(k + 1), now.state, {}};
    now = sample.end = stepped(material, sample.t, dt, sample.F0, sample.F1, now.state);
    if (k % 7 == 3) samples.push_back(std::move(sample));
  }
  return samples;
}

namespace {

Sample last_step(const Specimen& specimen, const std::function<Tensor(double)>& F) {
  constexpr int steps = 5;
  Sample sample{0, 1.0 / steps, F(0), F(0), specimen.rest_state(), {}};
  for (int k = 0; k < steps; ++k) {
    if (k > 0) sample.state0 = sample.end.state;
    sample.t = k * sample.dt;
    sample.F0 = F(sample.t);
    sample.F1 = F(sample.t + sample.dt);
    sample.end = stepped(*specimen.material, sample.t, sample.dt, sample.F0, sample.F1, sample.state0);
  }
  return sample;
}

}  // namespace

std::vector<Sample> samples_beside_histories(const Specimen& specimen) {
  const double a = specimen.amplitude;
  const auto along_axes = [a](double t) { return Tensor(Vector3(1 + a * t, 1 + a * t, 1 - 0.5 * a * t).asDiagonal()); };
  const auto equal = [&](bool three) {
    return [&, three](double t) { return equal_stretches(specimen.space, a * t, three, 0); };
  };
  const auto held = [&](double t) { return specimen.space.stretch(a, std::min(2 * t, 1.0)); };
  std::vector<Sample> samples;
  for (const std::function<Tensor(double)>& F :
       {std::function<Tensor(double)>([](double) { return Tensor(Tensor::Identity()); }),
        std::function<Tensor(double)>(along_axes), std::function<Tensor(double)>(equal(false)),
        std::function<Tensor(double)>(equal(true)), std::function<Tensor(double)>(held)}) {
    try {
      samples.push_back(last_step(specimen, F));
    } catch (const MaterialFailure&) {
    }
  }
  return samples;
}

}  // namespace assay::check
