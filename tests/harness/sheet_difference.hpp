// SPDX-License-Identifier: BSD-3-Clause
// Sheets against closed forms.
#pragma once

#include <algorithm>
#include <cmath>

#include "harness/sheet/sheet.hpp"

namespace assay {

struct Difference {
  double tau = 0, dtau = 0;
};

/// Against a closed form at places off any node, relative to the largest component.
template <class Exact>
Difference largest_difference(const Sheet& sheet, const Path& path, double end, const Exact& exact) {
  Difference d;
  double tau_scale = 0, dtau_scale = 0;
  for (int i = 0; i < 23; ++i) {
    for (int j = 0; j < 29; ++j) {
      const double xi = path.parameter.lower + path.parameter.width() * (i + 0.37) / 23, t = end * (j + 0.61) / 29;
      Tensor tau, dtau, tau_exact, dtau_exact;
      sheet.isochrone(t).at(xi, tau, dtau);
      exact(xi, t, tau_exact, dtau_exact);
      d.tau = std::max(d.tau, (tau - tau_exact).cwiseAbs().maxCoeff());
      d.dtau = std::max(d.dtau, (dtau - dtau_exact).cwiseAbs().maxCoeff());
      tau_scale = std::max(tau_scale, tau_exact.cwiseAbs().maxCoeff());
      dtau_scale = std::max(dtau_scale, dtau_exact.cwiseAbs().maxCoeff());
    }
  }
  return {d.tau / tau_scale, d.dtau / dtau_scale};
}

/// Jaumann hypoelasticity: sigma12 = mu sin gamma; the increments need sub-stepping, the slope is known too.
inline void jaumann(const Path& path, double xi, double t, Tensor& tau, Tensor& dtau) {
  const double mu = 1e3 / 2.6, g = path.amplitude(t), gamma = 2 * xi * g;
  const auto at = [&](double s12, double s11) {
    Tensor sigma = Tensor::Zero();
    sigma(0, 1) = sigma(1, 0) = s12;
    sigma(0, 0) = s11;
    sigma(1, 1) = -s11;
    return sigma;
  };
  const Tensor sigma = at(mu * std::sin(gamma), mu * (std::cos(gamma) - 1));
  const Tensor slope = at(mu * std::cos(gamma), -mu * std::sin(gamma));
  Tensor inverse_transpose = Tensor::Identity(), change = Tensor::Zero();
  inverse_transpose(0, 1) = -gamma;  // F^-T, J = 1
  change(0, 1) = -1;
  tau = sigma * inverse_transpose;
  dtau = 2 * g * (slope * inverse_transpose + sigma * change);
}

}  // namespace assay
