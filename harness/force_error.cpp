// SPDX-License-Identifier: BSD-3-Clause
#include "harness/force_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/body_force.hpp"

namespace assay {

namespace {

constexpr int radii = 64, times = 32;  ///< at which b is looked at, away from the ring's edges

}  // namespace

double force_error(const Vortex& vortex, double density, const Sheet& sheet, double end) {
  const double tau_error = sheet.error().tau * sheet.error().tau_scale;
  const double dtau_error = sheet.error().dtau * sheet.error().dtau_scale;
  double largest_error = 0, largest_force = 0;
  for (int j = 0; j < times; ++j) {
    const double t = end * (j + 0.5) / times;
    const AmplitudeValue g = vortex.amplitude.at(t);
    const Slice slice = sheet.slice(t);
    for (int i = 0; i < radii; ++i) {
      const double R = vortex.inner + (vortex.outer - vortex.inner) * (i + 0.5) / radii;
      const Vortex::Profile profile = vortex.profile(R);
      Tensor tau, dtau;
      slice.at(profile.xi, tau, dtau);
      const Polar b = body_force(profile, g, density, R, tau, dtau);
      largest_force = std::max(largest_force, std::hypot(b.r, b.theta));
      const double divergence = std::abs(profile.xi_prime) * dtau_error +
                                (std::abs(g.value * profile.h_prime) + 2 / R) * tau_error;  // (26), (27)
      largest_error = std::max(largest_error, std::numbers::sqrt2 * divergence / density);  // both components
    }
  }
  return largest_force > 0 ? largest_error / largest_force : 0;
}

}  // namespace assay
