// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assay {

namespace {

constexpr int radii = 64, times = 32;  ///< at which b is looked at, away from the ring's edges

}  // namespace

double force_error(const Motion& motion, double density, const Sheet& sheet, double end) {
  const double tau_error = sheet.error().tau * sheet.error().tau_scale;
  const double dtau_error = sheet.error().dtau * sheet.error().dtau_scale;
  const Annulus ring = *ring_of(motion);
  double largest_error = 0, largest_force = 0;
  for (int j = 0; j < times; ++j) {
    const double t = end * (j + 0.5) / times;
    const Isochrone isochrone = sheet.isochrone(t);
    for (int i = 0; i < radii; ++i) {
      const double R = ring.inner + (ring.outer - ring.inner) * (i + 0.5) / radii;
      const RingParameter xi = ring_parameter(motion, R);
      const RingKinematics kinematics = ring_kinematics(motion, R, t);
      Tensor tau, dtau;
      isochrone.at(xi.value, tau, dtau);
      const Polar b = kinematics.body_force(density, R, tau, xi.slope * dtau);
      largest_force = std::max(largest_force, std::hypot(b.r, b.theta));
      const double divergence =
          std::abs(xi.slope) * dtau_error + (std::abs(kinematics.alpha_slope) + 2 / R) * tau_error;  // (26), (27)
      largest_error = std::max(largest_error, std::numbers::sqrt2 * divergence / density);           // both components
    }
  }
  return largest_force > 0 ? largest_error / largest_force : 0;
}

}  // namespace assay
