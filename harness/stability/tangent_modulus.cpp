// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/tangent_modulus.hpp"

#include <algorithm>
#include <array>

#include "harness/material/checked_update.hpp"

namespace assay {

namespace {

constexpr std::size_t sides = 18;  ///< points of a step: 2 j and 2 j + 1 on the two sides in component j
constexpr std::size_t most_steps = ASSAY_BATCH_MAX / sides;

/// Points of a batch and what they come to.
struct ProbedBatch {
  ProbedBatch(const Material& material, std::span<const ProbedStep> steps, double size)
      : n(sides * steps.size()),
        before(9 * n),
        after(9 * n),
        cauchy(9 * n),
        state0(material.state_size() * n),
        state1(material.state_size() * n) {
    for (std::size_t p = 0; p < n; ++p) {
      const ProbedStep& step = steps[p / sides];
      const std::size_t side = p % sides;
      put_tensor(step.F0, before.data(), n, p);
      put_tensor(step.F1, after.data(), n, p);
      if (material.takes(static_cast<int>(side / 2))) after[side / 2 * n + p] += side % 2 ? size : -size;
      put_point(step.state0, state0.data(), n, p);
    }
  }

  Tensor stress(std::size_t p) const {
    return first_piola_kirchhoff(tensor_at(cauchy.data(), n, p), tensor_at(after.data(), n, p));
  }

  /// Of the step whose points begin there.
  TangentModulus modulus(const Material& material, std::size_t first) const {
    TangentModulus A = TangentModulus::Zero();
    for (std::size_t j = 0; j < 9; ++j) {
      if (!material.takes(static_cast<int>(j))) continue;
      const std::size_t low = first + 2 * j, high = low + 1;
      const Tensor slope = (stress(high) - stress(low)) / (after[j * n + high] - after[j * n + low]);
      for (int i = 0; i < 9; ++i) A(i, static_cast<int>(j)) = component(slope, i);
    }
    return A;
  }

  std::size_t n;
  std::vector<double> before, after, cauchy, state0, state1;
};

}  // namespace

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F,
                                     const std::vector<double>& state0) {
  return probe_tangent_modulus(material, t, dt, F, F, state0, difference_of_F);
}

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                                     const std::vector<double>& state0, double size) {
  return probe_tangent_moduli(material, t, dt, std::array{ProbedStep{F0, F1, state0}}, size).front();
}

std::vector<TangentModulus> probe_tangent_moduli(const Material& material, double t, double dt,
                                                 std::span<const ProbedStep> steps, double size) {
  std::vector<TangentModulus> found;
  for (std::size_t begin = 0; begin < steps.size(); begin += most_steps) {
    const auto some = steps.subspan(begin, std::min(most_steps, steps.size() - begin));
    ProbedBatch batch(material, some, size);
    checked_update(material, 0, t, dt, batch.n, batch.before.data(), batch.after.data(), batch.state0.data(),
                   batch.state1.data(), batch.cauchy.data());
    for (std::size_t k = 0; k < some.size(); ++k) found.push_back(batch.modulus(material, k * sides));
  }
  return found;
}

}  // namespace assay
