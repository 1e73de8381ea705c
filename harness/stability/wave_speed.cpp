// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/wave_speed.hpp"

#include <algorithm>
#include <cmath>

#include "harness/history/point_driver.hpp"
#include "harness/material/offer.hpp"
#include "harness/stability/tangent_modulus.hpp"

namespace assay {

namespace {

constexpr int speed_samples = 9;          ///< of xi, and of t in each piece
constexpr double speed_tolerance = 1e-3;  ///< of the states at which waves are looked at
constexpr double probing_share = 1e-4;    ///< the probing step's dt: a usual step of an explicit run

double own_wave_speed(const Material& material, const Offer<assay_wave_speed>& offer, double density,
                      const Histories& h, const Path& path) {
  const std::size_t n = h.xi.size();
  std::vector<double> F(9 * n), speed(n);
  double fastest = 0;
  for (std::size_t row = 0; row < h.times.size(); ++row) {
    for (std::size_t p = 0; p < n; ++p) put_tensor(path.deformation_gradient(h.xi[p], h.times[row]), F.data(), n, p);
    if (offer(density, n, F.data(), h.points[row].cauchy.data(), h.points[row].state.data(), speed.data()) ==
        ASSAY_FAILED) {
      throw MaterialFailure(with_reason("the material failed to give its wave speed", material), h.xi[0], h.times[row]);
    }
    for (std::size_t p = 0; p < n; ++p) {
      if (!is_wave_speed(speed[p])) {
        throw MaterialFailure("the wave speed that the material gives is no finite number of 0 or more", h.xi[p],
                              h.times[row]);
      }
      fastest = std::max(fastest, speed[p]);
    }
  }
  return fastest;
}

/// In a batch or, where that fails, one by one until the place is known.
std::vector<TangentModulus> moduli_of(const Material& material, double t, double dt, std::span<const double> xi,
                                      std::span<const ProbedStep> steps) {
  try {
    return probe_tangent_moduli(material, t, dt, steps, difference_of_F);
  } catch (const MaterialFailure&) {
    std::vector<TangentModulus> found;
    for (std::size_t p = 0; p < steps.size(); ++p) {
      try {
        found.push_back(probe_tangent_moduli(material, t, dt, steps.subspan(p, 1), difference_of_F).front());
      } catch (MaterialFailure& failure) {
        failure.xi = xi[p];
        throw;
      }
    }
    return found;
  }
}

double probed_wave_speed(const Material& material, double density, double dt, const Histories& h, const Path& path,
                         WaveFrame frame) {
  const std::size_t n = h.xi.size();
  std::vector<ProbedStep> steps(n);
  double fastest = 0;
  for (std::size_t row = 0; row < h.times.size(); ++row) {
    for (std::size_t p = 0; p < n; ++p) {
      steps[p].F0 = steps[p].F1 = path.deformation_gradient(h.xi[p], h.times[row]);
      steps[p].state0 = point_of(h.points[row].state.data(), n, p, material.state_size());
    }
    const std::vector<TangentModulus> moduli = moduli_of(material, h.times[row], dt, h.xi, steps);
    for (std::size_t p = 0; p < n; ++p) {
      const Tensor& F = steps[p].F0;
      fastest =
          std::max(fastest, fastest_wave(moduli[p], frame == WaveFrame::current ? F : Tensor::Identity(), density));
    }
  }
  return fastest;
}

}  // namespace

bool is_wave_speed(double c) { return c >= 0 && std::isfinite(c); }

double fastest_wave(const TangentModulus& A, const Tensor& F, double density) {
  TangentModulus pushed;  // N.A.N = n.pushed.n
  for (int i = 0; i < 9; i += 3) {
    for (int k = 0; k < 9; k += 3) pushed.block<3, 3>(i, k) = F * A.block<3, 3>(i, k) * F.transpose();
  }
  return std::sqrt(std::max(0.0, largest_acoustic_eigenvalue(pushed).value) / density);
}

double fastest_wave_on_path(const Material& material, const Path& given, double density, double end, WaveFrame frame) {
  const bool curve =
      material.path_independent() && given.straight();  // then every state is reached by straight loading
  const Path path = curve ? loading_path(given, end) : given;
  std::vector<double> xi, times, breaks{0};
  for (int k = 0; k < speed_samples; ++k)
    xi.push_back(path.parameter.lower + path.parameter.width() * k / (speed_samples - 1));
  if (curve) end = 1;
  for (const double t : path.reversals(end)) breaks.push_back(t);
  breaks.push_back(end);
  times.push_back(0);
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
    for (int k = 1; k < speed_samples; ++k)
      times.push_back(breaks[b] + (breaks[b + 1] - breaks[b]) * k / (speed_samples - 1));
  }
  DriverOptions options;
  options.tolerance = speed_tolerance;
  const Histories h = integrate_histories(material, path, xi, times, options);
  const Offer<assay_wave_speed> offer(material);
  if (frame == WaveFrame::current && offer) {
    const double own = own_wave_speed(material, offer, density, h, path);
    if (own > 0) return own;  // one that is 0 everywhere says nothing
  }
  return probed_wave_speed(material, density, probing_share * end, h, path, frame);
}

}  // namespace assay
