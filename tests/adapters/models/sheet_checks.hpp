// SPDX-License-Identifier: BSD-3-Clause
// Sheets and body forces of a model against its independent equations.
#pragma once

#include <algorithm>
#include <random>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/central_difference.hpp"
#include "harness/sheet/sheet.hpp"
#include "tests/adapters/models/model_cases.hpp"
#include "tests/adapters/models/property_samples.hpp"
#include "tests/harness/exact/vortex_force.hpp"

namespace assay::model_tests {

/// The vortex of the paper with the amplitude of a case, to two periods (`sine`) or one (`one_minus_cosine`).
struct Setting {
  Vortex vortex;
  double end;
};

inline Setting setting_of(const ModelCase& c, Amplitude::Type type) {
  return {Vortex{0.75, 1.25, 2, {type, c.peak, 1.0}}, type == Amplitude::Type::sine ? 2.0 : 1.0};
}

constexpr double sheet_tolerance = 1e-8;

inline Sheet sheet_of(const ModelCase& c, const Setting& setting) {
  return Sheet(c.material(), setting.vortex.baseline(), {.tolerance = sheet_tolerance, .end = setting.end});
}

inline std::vector<double> turns_before(const Amplitude& g, double t) {
  std::vector<double> turns;
  for (const double turn : g.reversals(t)) {
    if (turn < t) turns.push_back(turn);
  }
  return turns;
}

/// tau of the baseline at (xi, t) by the equations.
inline Tensor exact_tau(const ModelCase& c, const Amplitude& g, double xi, double t) {
  const auto F = [&](double s) {
    Tensor A = Tensor::Identity();
    A(1, 0) = 2 * xi * g.at(s).value;
    return A;
  };
  const auto F_rate = [&](double s) {
    Tensor A = Tensor::Zero();
    A(1, 0) = 2 * xi * g.at(s).rate;
    return A;
  };
  return piola(c.stress({F, F_rate, t, turns_before(g, t)}), F(t));
}

/// Distance in xi from the nearest kink of the sheet at the time t, xi = 0 and the ends of the range.
inline double distance_from_kinks(const Sheet& sheet, const Interval& range, double xi, double t) {
  std::vector<double> kinks = sheet.has_kinks() ? sheet.isochrone(t).kinks() : std::vector<double>();
  kinks.insert(kinks.end(), {range.lower, range.upper, 0});
  double nearest = range.width();
  for (const double kink : kinks) nearest = std::min(nearest, std::abs(xi - kink));
  return nearest;
}

/// Errors relative to the largest component over the points.
struct SheetDifference {
  double tau = 0, dtau = 0, tau_scale = 0, dtau_scale = 0;

  void add(const Tensor& found, const Tensor& exact, double& error, double& scale) {
    error = std::max(error, (found - exact).cwiseAbs().maxCoeff());
    scale = std::max(scale, exact.cwiseAbs().maxCoeff());
  }
};

/// d/dxi of f(xi + by) at by = 0 by differences, whose step is shortened until a shorter one says the same to `same`,
/// if that is ever so.
template <class F>
Tensor settled_difference(const F& f, double step, double same) {
  constexpr int most = 4;
  constexpr double shorter = 0.4;
  const auto difference = [&](double h) { return central_difference([&](int k) { return f(k * h); }, h); };
  Tensor found = difference(step);
  double change = 0;
  for (int k = 0; k < most && (k == 0 || change > same); ++k) {
    const Tensor next = difference(step *= shorter);
    change = (next - found).cwiseAbs().maxCoeff();
    found = next;
  }
  return found;
}

/// At pseudo-random points more than 1 % of the range of xi away from kinks.
inline SheetDifference sheet_difference(const ModelCase& c, const Setting& setting, const Sheet& sheet, int points) {
  constexpr double away = 0.01, step_share = 0.04, longest_step = 0.003, settled = 3e-10;
  const Interval range = setting.vortex.xi_range();
  std::mt19937 random(20240607);
  const auto uniform = [&] { return random() / 4294967296.0; };
  SheetDifference d;
  for (int i = 0; i < points;) {
    const double xi = range.lower + uniform() * range.width(), t = setting.end * (0.01 + 0.99 * uniform());
    const double distance = distance_from_kinks(sheet, range, xi, t);
    if (distance < away * range.width()) continue;
    Tensor tau, dtau;
    sheet.at(xi, t, tau, dtau);
    const double step = std::min(step_share * distance, longest_step * range.width());
    const auto exact = [&](double by) { return exact_tau(c, setting.vortex.amplitude, xi + by, t); };
    d.add(tau, exact(0), d.tau, d.tau_scale);
    d.add(dtau, settled_difference(exact, step, settled * sheet.error().dtau_scale), d.dtau, d.dtau_scale);
    ++i;
  }
  d.tau /= d.tau_scale;
  d.dtau /= d.dtau_scale;
  return d;
}

}  // namespace assay::model_tests
