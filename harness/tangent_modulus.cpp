// SPDX-License-Identifier: BSD-3-Clause
#include "harness/tangent_modulus.hpp"

#include "harness/checked_update.hpp"

namespace assay {

namespace {

constexpr double difference_of_F = 1e-5;  ///< of F, central: error about 1e-10 relative, round-off about 1e-11

}  // namespace

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F,
                                     const std::vector<double>& state0) {
  return probe_tangent_modulus(material, t, dt, F, F, state0, difference_of_F);
}

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                                     const std::vector<double>& state0, double size) {
  constexpr std::size_t n = 18;  // points of the batch: 2 j and 2 j + 1 on the two sides in component j
  const auto is_taken = [&](std::size_t c) { return material.takes(static_cast<int>(c)); };
  const std::size_t states = state0.size();
  std::vector<double> before(9 * n), after(9 * n), cauchy(9 * n), history(states * n), unused(states * n);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) {
      before[c * n + p] = component(F0, static_cast<int>(c));
      after[c * n + p] = component(F1, static_cast<int>(c)) + (c == p / 2 && is_taken(c) ? (p % 2 ? size : -size) : 0);
    }
    for (std::size_t c = 0; c < states; ++c) history[c * n + p] = state0[c];
  }
  checked_update(material, 0, t, dt, n, before.data(), after.data(), history.data(), unused.data(), cauchy.data());
  const auto stress = [&](std::size_t p) {
    Tensor sigma, F;
    for (std::size_t c = 0; c < 9; ++c) {
      component(sigma, static_cast<int>(c)) = cauchy[c * n + p];
      component(F, static_cast<int>(c)) = after[c * n + p];
    }
    return first_piola_kirchhoff(sigma, F);
  };
  TangentModulus A = TangentModulus::Zero();
  for (std::size_t j = 0; j < 9; ++j) {
    if (!is_taken(j)) continue;
    const Tensor slope = (stress(2 * j + 1) - stress(2 * j)) / (after[j * n + 2 * j + 1] - after[j * n + 2 * j]);
    for (int i = 0; i < 9; ++i) A(i, static_cast<int>(j)) = component(slope, i);
  }
  return A;
}

}  // namespace assay
