// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/stability_probe.hpp"

#include <algorithm>

#include "harness/history/history.hpp"
#include "harness/material/checked_update.hpp"
#include "harness/numeric/norms.hpp"

namespace assay {

namespace {

constexpr double share_of_end = 1e-4;       ///< a usual step of an explicit run: dt at rest
constexpr double backward = 1e-6;           ///< share of the end over which the direction of loading is taken
constexpr double rest_difference = 1e-5;    ///< central: error about 1e-10, round-off about 1e-11
constexpr double neutral_threshold = 1e-8;  ///< of the largest eigenvalue: what differences can tell from zero
constexpr double coarse_noise = 1e-4;       ///< relative noise of fine differences from which coarse ones are taken

/// That of a solid whose waves in the plane are those of A, and whose others are neither the slowest nor the fastest.
TangentModulus of_solid(const TangentModulus& A) {
  const auto at = [](int i, int J) { return 3 * i + J; };
  TangentModulus solid = TangentModulus::Zero();
  double sum = 0;
  for (const int a : {at(0, 0), at(0, 1), at(1, 0), at(1, 1)}) {
    for (const int b : {at(0, 0), at(0, 1), at(1, 0), at(1, 1)}) solid(a, b) = A(a, b);
    sum += A(a, a);
  }
  for (const int c : {at(0, 2), at(1, 2), at(2, 0), at(2, 1), at(2, 2)}) solid(c, c) = sum / 4;
  return solid;
}

/// By differences of that size.
TangentModulus modulus_of(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                          const std::vector<double>& state, double size) {
  const TangentModulus A = probe_tangent_modulus(material, t, dt, F0, F1, state, size);
  return material.has(ASSAY_IN_PLANE) ? of_solid(A) : A;
}

}  // namespace

StabilityProbe::StabilityProbe(const Material& material, const Path& path, double end)
    : material_(material), path_(path), end_(end) {
  breaks_ = path.reversals(end);
  breaks_.insert(breaks_.begin(), 0.0);
  breaks_.push_back(end);
  double fastest = 0;
  for (const double xi : {path.parameter.lower, path.parameter.upper}) {
    for (std::size_t b = 0; b + 1 < breaks_.size(); ++b) {
      const Tensor change = path.deformation_gradient(xi, breaks_[b + 1]) - path.deformation_gradient(xi, breaks_[b]);
      fastest = std::max(fastest, change.norm() / (breaks_[b + 1] - breaks_[b]));
    }
  }
  rate_ = fastest;
  look_at_rest();
}

/// The smallest eigenvalue at rest; the scale of all others, and what differences cannot tell from zero.
void StabilityProbe::look_at_rest() {
  const std::vector<double> state = state_at_rest(material_, path_);
  const Tensor I = Tensor::Identity();
  const double dt = share_of_end * end_;
  const auto probed = [&](double step, double size) { return modulus_of(material_, 0, step, I, I, state, size); };
  const TangentModulus one = probed(dt, fine.difference), other = probed(dt, 3 * fine.difference);
  const double noise = stable_norm(one - other) / stable_norm(one);
  if (!(noise < coarse_noise)) steps_ = coarse;
  const double size = std::max(rest_difference, steps_.difference);
  TangentModulus A = probed(dt, size);
  noise_floor_ = neutral_threshold * largest_acoustic_eigenvalue(A).value;
  if (steps_.difference == coarse.difference) {
    noise_floor_ = std::max(noise_floor_, 10 * stable_norm(A - probed(dt, 3 * size)));
  }
  // A viscous stress adds A_v / dt: it carries no wave, and two steps tell it from an elastic one
  if (material_.has(ASSAY_RATE_DEPENDENT)) A = 2 * probed(2 * dt, size) - A;
  scale_ = largest_acoustic_eigenvalue(A).value;
  rest_ = smallest_acoustic_eigenvalue(A);
}

/// Unit direction in which F moves on its way to the time t; zero where it stands still.
Tensor StabilityProbe::loading(double xi, double t) const {
  const double before = std::max(0.0, t - backward * end_);
  const Tensor change = path_.deformation_gradient(xi, t) - path_.deformation_gradient(xi, before);
  const double size = change.norm();
  return size > 1e-14 ? Tensor(change / size) : Tensor(Tensor::Zero());
}

AcousticExtreme StabilityProbe::at(double xi, double t, const std::vector<double>& state) const {
  return at(std::span(&xi, 1), t, std::span(&state, 1)).front();
}

std::vector<AcousticExtreme> StabilityProbe::at(std::span<const double> xi, double t,
                                                std::span<const std::vector<double>> states) const {
  std::vector<AcousticExtreme> found(xi.size(), {scale_, Vector3::Zero()});
  std::vector<std::size_t> moving;
  std::vector<ProbedStep> steps;
  for (std::size_t k = 0; k < xi.size(); ++k) {
    const Tensor F = path_.deformation_gradient(xi[k], t), along = loading(xi[k], t);
    if (along.isZero(0)) continue;
    moving.push_back(k);
    steps.push_back({F, F + steps_.settle * along, states[k]});
  }
  if (steps.empty()) return found;
  const double dt = rate_ > 0 ? 1 / rate_ : end_;  // per unit of strain
  const std::vector<std::vector<double>> settled = settled_states(xi[moving.front()], t, steps, steps_.settle * dt);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Tensor start = steps[i].F1;
    steps[i] = {start, start + steps_.base * loading(xi[moving[i]], t), settled[i]};
  }
  const auto moduli = probe_tangent_moduli(material_, t, steps_.base * dt, steps, steps_.difference);
  for (std::size_t i = 0; i < moduli.size(); ++i) {
    const TangentModulus& A = moduli[i];
    found[moving[i]] = smallest_acoustic_eigenvalue(material_.has(ASSAY_IN_PLANE) ? of_solid(A) : A);
  }
  return found;
}

/// The states at the ends of the steps.
std::vector<std::vector<double>> StabilityProbe::settled_states(double xi, double t, std::span<const ProbedStep> steps,
                                                                double dt) const {
  const std::size_t n = steps.size(), size = material_.state_size();
  std::vector<std::vector<double>> settled(n, std::vector<double>(size));
  if (size == 0) return settled;
  std::vector<double> F0(9 * n), F1(9 * n), cauchy(9 * n), before(size * n), after(size * n);
  for (std::size_t p = 0; p < n; ++p) {
    put_tensor(steps[p].F0, F0.data(), n, p);
    put_tensor(steps[p].F1, F1.data(), n, p);
    put_point(steps[p].state0, before.data(), n, p);
  }
  checked_update(material_, xi, t, dt, n, F0.data(), F1.data(), before.data(), after.data(), cauchy.data());
  for (std::size_t p = 0; p < n; ++p) settled[p] = point_of(after.data(), n, p, size);
  return settled;
}

}  // namespace assay
