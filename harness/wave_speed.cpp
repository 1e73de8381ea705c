// SPDX-License-Identifier: BSD-3-Clause
#include "harness/wave_speed.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/point_driver.hpp"

namespace assay {

namespace {

constexpr double difference = 1e-5;         ///< of F, central: error about 1e-10 relative, round-off about 1e-11
constexpr int directions = 400;             ///< on the half sphere: neighbours 7 degrees apart, c within 1 %
constexpr int samples = 9;                  ///< of xi, and of t in each piece
constexpr double history_tolerance = 1e-3;  ///< of the states at which waves are looked at
constexpr double share_of_end = 1e-4;       ///< the probing step's dt: a usual step of an explicit run

/// Directions on the upper half sphere in a golden-angle spiral.
Vector3 direction(int k) {
  const double z = (k + 0.5) / directions, phi = k * std::numbers::pi * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

double own_wave_speed(const Material& material, const assay_wave_speed& extension, double density, const Histories& h,
                      const Path& path) {
  const std::size_t n = h.xi.size();
  std::vector<double> F(9 * n), speed(n);
  double fastest = 0;
  for (std::size_t row = 0; row < h.times.size(); ++row) {
    for (std::size_t p = 0; p < n; ++p) {
      const Tensor f = path.deformation_gradient(h.xi[p], h.times[row]);
      for (int c = 0; c < 9; ++c) F[static_cast<std::size_t>(c) * n + p] = component(f, c);
    }
    if (extension.wave_speed(material.self(), density, n, F.data(), h.points[row].cauchy.data(),
                             h.points[row].state.data(), speed.data()) == ASSAY_FAILED) {
      throw MaterialFailure("the material failed to give its wave speed", h.xi[0], h.times[row]);
    }
    for (const double c : speed) fastest = std::max(fastest, c);
  }
  return fastest;
}

double probed_wave_speed(const Material& material, double density, double dt, const Histories& h, const Path& path) {
  const std::size_t n = h.xi.size();
  std::vector<double> state(material.state_size());
  double fastest = 0;
  for (std::size_t row = 0; row < h.times.size(); ++row) {
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t c = 0; c < state.size(); ++c) state[c] = h.points[row].state[c * n + p];
      const Tensor F = path.deformation_gradient(h.xi[p], h.times[row]);
      try {
        const TangentModulus A = probe_tangent_modulus(material, h.times[row], dt, F, state);
        fastest = std::max(fastest, fastest_wave(A, F, density));
      } catch (MaterialFailure& failure) {
        failure.xi = h.xi[p];
        throw;
      }
    }
  }
  return fastest;
}

}  // namespace

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F,
                                     const std::vector<double>& state0) {
  return probe_tangent_modulus(material, t, dt, F, F, state0, difference);
}

TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                                     const std::vector<double>& state0, double size) {
  constexpr std::size_t n = 18;  // points of the batch: 2 j and 2 j + 1 on the two sides in component j
  const std::size_t states = state0.size();
  std::vector<double> before(9 * n), after(9 * n), cauchy(9 * n), history(states * n), unused(states * n);
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t c = 0; c < 9; ++c) {
      before[c * n + p] = component(F0, static_cast<int>(c));
      after[c * n + p] = component(F1, static_cast<int>(c)) + (c == p / 2 ? (p % 2 ? size : -size) : 0);
    }
    for (std::size_t c = 0; c < states; ++c) history[c * n + p] = state0[c];
  }
  const UpdateReport report =
      material.update(t, dt, n, before.data(), after.data(), history.data(), unused.data(), cauchy.data());
  if (report.worst == ASSAY_FAILED) {
    throw MaterialFailure(
        report.message, 0, t,
        failed_step(t, dt, n, report.worst_point, before.data(), after.data(), history.data(), states));
  }
  const auto stress = [&](std::size_t p) {
    Tensor sigma, F;
    for (std::size_t c = 0; c < 9; ++c) {
      component(sigma, static_cast<int>(c)) = cauchy[c * n + p];
      component(F, static_cast<int>(c)) = after[c * n + p];
    }
    return first_piola_kirchhoff(sigma, F);
  };
  TangentModulus A;
  for (std::size_t j = 0; j < 9; ++j) {
    const Tensor slope = (stress(2 * j + 1) - stress(2 * j)) / (after[j * n + 2 * j + 1] - after[j * n + 2 * j]);
    for (int i = 0; i < 9; ++i) A(i, static_cast<int>(j)) = component(slope, i);
  }
  return A;
}

double fastest_wave(const TangentModulus& A, const Tensor& F, double density) {
  double largest = 0;
  for (int k = 0; k < directions; ++k) {
    const Vector3 N = F.transpose() * direction(k);
    Tensor Q = Tensor::Zero();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int a = 0; a < 3; ++a) {
          for (int b = 0; b < 3; ++b) Q(i, j) += A(3 * i + a, 3 * j + b) * N(a) * N(b);
        }
      }
    }
    const Eigen::SelfAdjointEigenSolver<Tensor> solver(0.5 * (Q + Q.transpose()), Eigen::EigenvaluesOnly);
    largest = std::max(largest, solver.eigenvalues()(2));
  }
  return std::sqrt(largest / density);
}

double fastest_wave_on_path(const Material& material, const Path& given, double density, double end) {
  const bool curve =
      material.path_independent() && given.straight();  // then every state is reached by straight loading
  const Path path = curve ? loading_path(given, end) : given;
  std::vector<double> xi, times, breaks{0};
  for (int k = 0; k < samples; ++k) xi.push_back(path.parameter.lower + path.parameter.width() * k / (samples - 1));
  if (curve) end = 1;
  for (const double t : path.reversals(end)) breaks.push_back(t);
  breaks.push_back(end);
  times.push_back(0);
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    for (int k = 1; k < samples; ++k) times.push_back(breaks[b] + (breaks[b + 1] - breaks[b]) * k / (samples - 1));
  }
  DriverOptions options;
  options.tolerance = history_tolerance;
  const Histories h = integrate_histories(material, path, xi, times, options);
  const auto* extension = material.extension<assay_wave_speed>(ASSAY_EXTENSION_WAVE_SPEED);
  if (extension && extension->wave_speed) return own_wave_speed(material, *extension, density, h, path);
  return probed_wave_speed(material, density, share_of_end * end, h, path);
}

}  // namespace assay
