// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/specimen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace assay::check {

namespace {

constexpr double largest_amplitude = 0.15, least_amplitude = 1e-6;
constexpr double largest_under_pressure = 0.01;  ///< soils come apart soon
constexpr double probe = 0x1p-17;                ///< 8e-6, of probes from rest: most materials yield later; beside 1
                                                 ///< exact in single precision, too
constexpr double linear_within = 1e-3;           ///< relative: between probes of one and of two sizes
constexpr std::array<std::array<int, 2>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

struct Probes {
  Stiffness slope = Stiffness::Zero();  ///< by central differences of single steps from rest
  double one_sided = 0;                 ///< the largest difference between tension and compression, over the strain
};

/// About rest under a pressure [Pa], by steps of that length [s].
Probes probes_of(const Material& material, double pressure, double size, double length) {
  const std::vector<double> rest = state_at_rest(material, pressure);
  const Tensor at_rest = -pressure * Tensor::Identity();
  Probes probes;
  for (int column = 0; column < 6; ++column) {
    const int i = places[static_cast<std::size_t>(column)][0], j = places[static_cast<std::size_t>(column)][1];
    const auto stress = [&](double strain) {
      Tensor F = Tensor::Identity();
      F(i, j) += strain;
      if (i != j) F(j, i) += strain;
      return stepped(material, 0, length, Tensor::Identity(), F, rest).cauchy;
    };
    const Tensor there = stress(size), back = stress(-size), slope = (there - back) / (2 * size);
    probes.one_sided = std::max(probes.one_sided, (there + back - 2 * at_rest).cwiseAbs().maxCoeff() / (2 * size));
    for (int row = 0; row < 6; ++row) {
      const auto [k, l] = places[static_cast<std::size_t>(row)];
      probes.slope(row, column) = slope(k, l);
    }
  }
  return probes;
}

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
    return probes_of(*specimen.material, specimen.pressure, probe, length).slope.cwiseAbs().maxCoeff();
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
    return carries(material, pressure) && probes_of(material, pressure, probe, 1).slope.cwiseAbs().maxCoeff() != 0;
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
  const Probes whole = probes_of(material, specimen.pressure, probe, length);
  const Probes half = probes_of(material, specimen.pressure, 0.5 * probe, length);
  specimen.stiffness = whole.slope;
  specimen.modulus = specimen.stiffness.cwiseAbs().maxCoeff();
  const double change = (half.slope - whole.slope).cwiseAbs().maxCoeff();
  specimen.linear = std::max(change, whole.one_sided) < linear_within * specimen.modulus;
  specimen.amplitude = amplitude_of(specimen);
  return specimen;
}

Tensor stress_of(const Stiffness& stiffness, const Tensor& H) {
  Eigen::Matrix<double, 6, 1> strain;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = places[static_cast<std::size_t>(c)];
    strain(c) = 0.5 * (H(i, j) + H(j, i));
  }
  const Eigen::Matrix<double, 6, 1> stress = stiffness * strain;
  Tensor sigma;
  for (int c = 0; c < 6; ++c) {
    const auto [i, j] = places[static_cast<std::size_t>(c)];
    sigma(i, j) = sigma(j, i) = stress(c);
  }
  return sigma;
}

}  // namespace assay::check
