// SPDX-License-Identifier: BSD-3-Clause
// The body force of the generalized vortex, (24) to (33), and of the twisting ring, from the baseline response of any
// material.
#pragma once

#include <span>
#include <vector>

#include "harness/exact/response.hpp"
#include "harness/exact/ring_points.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/motion.hpp"

namespace assay {

/// DIV(T) in the first Piola-Kirchhoff form, (26) and (27), with (d tau / d R)_t = (d tau / d xi)_t xi' [N/m^3].
Polar divergence_piola(const RingProfile& profile, double g, double R, const Tensor& tau, const Tensor& dtau_dxi);

/// The same in the Cauchy form: d sigma11/dR + (sigma11 - sigma22)/R, d sigma12/dR + 2 sigma12/R, in baseline
/// components at fixed t [N/m^3]. Independent of divergence_piola; the two agree to round-off.
Polar divergence_cauchy(const RingProfile& profile, double g, double R, const Tensor& tau, const Tensor& dtau_dxi);

/// b = a - DIV(T)/rho0 at the radius R with its profile and the amplitude of the time, (32) and (33) with the inertia
/// term + R g'' h [m/s^2]; zero outside the ring.
Polar body_force(const RingProfile& profile, const AmplitudeValue& g, double density, double R, const Tensor& tau,
                 const Tensor& dtau_dxi);

/// The same from the radius and the time.
inline Polar body_force(const Vortex& vortex, double density, double R, double t, const Tensor& tau,
                        const Tensor& dtau_dxi) {
  return body_force(vortex.profile(R), vortex.amplitude.at(t), density, R, tau, dtau_dxi);
}

/// T = r tau q^T (20) [Pa] for the reference point X.
Tensor rotated_to(const Vortex& vortex, const Vector3& X, double t, const Tensor& tau);

/// b at fixed reference points, all of them at once for a time: computed once for each distinct radius.
class BodyForceField {
 public:
  /// motion: the vortex or the twisting ring; X, Y: reference positions [m] of n points.
  BodyForceField(const Motion& motion, double density, std::span<const double> X, std::span<const double> Y);

  /// Writes b [m/s^2], n components each.
  void evaluate(const Response& response, double t, std::span<double> b_x, std::span<double> b_y);

  const RingPoints& points() const { return points_; }

 private:
  Motion motion_;
  double density_;
  RingPoints points_;
  std::vector<RingProfile> profile_;  // of each distinct radius
  RingsInMotion rings_;               // where radii change
  std::vector<double> xi_;
  std::vector<Polar> force_;  // of each distinct radius: components along E_R, E_Theta
};

}  // namespace assay
