// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/specimen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assay::check {

namespace {

constexpr double largest_amplitude = 0.15, least_amplitude = 1e-6;
constexpr double largest_under_pressure = 0.01;  ///< soils come apart soon

/// The largest amplitude, halved from the first, that the material stands. Throws MaterialFailure where it stands none.
double amplitude_of(const Specimen& specimen) {
  for (double amplitude = specimen.pressure > 0 ? largest_under_pressure : largest_amplitude;; amplitude *= 0.5) {
    const Loading loading{[&](double t) { return stretch(amplitude, t); }, 1};
    try {
      march(*specimen.material, loading, {.steps = specimen.steps() / 4, .state = specimen.rest_state()});
      return amplitude;
    } catch (const MaterialFailure&) {
      if (amplitude < least_amplitude) throw;
    }
  }
}

/// Of what relaxes so short [s] that it does not, which shows by a stiffness that is the same in a shorter one.
double length_of_probes(const Specimen& specimen) {
  constexpr double brief = 1e-6, briefer = 1e-9, alike = 0.1;
  if (!specimen.rate_dependent()) return 1;
  const auto stiffness = [&](double length) {
    return probed(*specimen.material, specimen.pressure, length).stiffness.cwiseAbs().maxCoeff();
  };
  const double one = stiffness(brief), other = stiffness(briefer);
  return std::abs(one - other) < alike * one ? briefer : 1;
}

bool carries(const Material& material, double pressure) {
  try {
    state_at_rest(material, pressure);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace

Tensor stretch(double amplitude, double s) {
  Tensor A, B;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  B << -0.2, 0.5, 0.1, 0.5, 0.6, -0.4, 0.1, -0.4, -0.3;
  return Tensor::Identity() + amplitude * (std::sin(1.5 * std::numbers::pi * s) * A + s * s * B);
}

double pressure_at_rest(const Material& material) {
  const auto stiff = [&](double pressure) {
    return carries(material, pressure) && probed(material, pressure, 1).stiffness.cwiseAbs().maxCoeff() != 0;
  };
  constexpr double pressures[] = {0, 1e5, 1e4, 1e6, 1e3, 1e7, 1e2, 1e8, 10, 1e9, 1};  // [Pa]
  const auto* found = std::find_if(std::begin(pressures), std::end(pressures), stiff);
  return found == std::end(pressures) ? 0 : *found;
}

Loading out_and_back(const Specimen& specimen) {
  return {[a = specimen.amplitude](double t) { return stretch(a, 0.5 * t); }, 2};
}

Specimen examine(const Material& material, const Options& options) {
  Specimen specimen{&material, options};
  specimen.pressure = pressure_at_rest(material);
  const double length = length_of_probes(specimen);
  const Probed at_rest = probed(material, specimen.pressure, length);
  specimen.stiffness = at_rest.stiffness;
  specimen.modulus = specimen.stiffness.cwiseAbs().maxCoeff();
  specimen.linear = at_rest.linear;
  if (specimen.rate_dependent()) {
    specimen.parts = relaxing_parts(material, specimen.pressure, specimen.modulus);
  }
  specimen.amplitude = amplitude_of(specimen);
  return specimen;
}

}  // namespace assay::check
