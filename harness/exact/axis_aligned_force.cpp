// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/axis_aligned_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harness/history/point_driver.hpp"

namespace assay {

namespace {

constexpr double difference_step = 2e-3;     ///< of the cosines: the fourth power of it is rounding
constexpr double history_tolerance = 1e-13;  ///< of a step
constexpr std::array<double, 5> difference_places{-2, -1, 0, 1, 2};

/// tau of one history at all times [Pa].
std::vector<Tensor> history_of(const Material& material, const Path& path, double xi, std::span<const double> times) {
  const Histories found = integrate_histories(material, path, std::array{xi}, times, {.tolerance = history_tolerance});
  std::vector<Tensor> tau(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (int c = 0; c < 9; ++c) component(tau[k], c) = found.tau[k][static_cast<std::size_t>(c)];
  }
  return tau;
}

/// Of f at -2, -1, 1 and 2 steps.
Tensor difference(const std::array<Tensor, 5>& f) {
  return (f[0] - 8 * f[1] + 8 * f[3] - f[4]) / (12 * difference_step);
}

}  // namespace

std::vector<ExactStress> axis_aligned_stress(const Material& material, const AxisAligned& motion, double density,
                                             const Vector3& X, std::span<const double> times,
                                             const std::array<double, 3>& material_direction) {
  using std::numbers::pi;
  const int directions = motion.one_dimensional ? 1 : 2;
  const std::array<double, 2> cosine{std::cos(pi * X.x()), std::cos(pi * X.y())};
  const auto tau_at = [&](double of_X, double of_Y) {
    Path path = motion.section(of_Y);
    path.material_direction = material_direction;
    path.parameter.lower = std::min(path.parameter.lower, of_X), path.parameter.upper = std::max(1.0, of_X);
    return history_of(material, path, of_X, times);
  };
  const std::vector<Tensor> tau = tau_at(cosine[0], cosine[1]);
  std::vector<ExactStress> stress(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) {
    const ExactState state = motion.at(X, times[k]);
    stress[k] = {tau[k], cauchy_stress(tau[k], state.F), state.a};
  }
  for (int d = 0; d < directions; ++d) {
    const double slope = -pi * std::sin(pi * X(d));  // of the cosine [1/m]
    if (std::abs(slope) < 1e-12) continue;
    std::array<std::vector<Tensor>, 5> near;
    for (std::size_t i = 0; i < difference_places.size(); ++i) {
      std::array<double, 2> at = cosine;
      at[static_cast<std::size_t>(d)] += difference_places[i] * difference_step;
      if (difference_places[i] != 0) near[i] = tau_at(at[0], at[1]);
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Tensor dtau = slope * difference({near[0][k], near[1][k], tau[k], near[3][k], near[4][k]});
      stress[k].body_force -= dtau.col(d) / density;  // (DIV P)_i = d P_iJ / d X_J
    }
  }
  return stress;
}

}  // namespace assay
