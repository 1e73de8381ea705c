// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact_solution.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

RingKinematics ring_kinematics(const Motion& motion, double R, double t) {
  if (const auto* ring = std::get_if<TwistingRing>(&motion)) return ring->ring(R, t);
  return std::get<Vortex>(motion).ring(R, t);
}

double ring_parameter(const Motion& motion, double R) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) return vortex->profile(R).xi;
  const auto& ring = std::get<TwistingRing>(motion);
  return std::clamp(R, ring.inner(), ring.outer());
}

void ExactSolution::baseline_stress(double R, double t, Tensor& tau, Tensor& dtau_dR) const {
  (*response())->at(ring_parameter(motion_, R), t, tau, dtau_dR);
  if (const auto* vortex = std::get_if<Vortex>(&motion_)) dtau_dR *= vortex->profile(R).xi_prime;  // (21), corrected
}

ExactStress ExactSolution::stress(const Vector3& X, double t) const {
  const ExactState now = state(X, t);
  ExactStress stress;
  if (homogeneous()) {
    stress.first_piola_kirchhoff = (*homogeneous())->at(t);
    stress.body_force = now.a;
  } else {
    const double R = std::hypot(X.x(), X.y());
    const RingKinematics kinematics = ring_kinematics(motion_, R, t);
    Tensor tau, dtau_dR;
    baseline_stress(R, t, tau, dtau_dR);
    stress.first_piola_kirchhoff = kinematics.first_piola_kirchhoff(X, tau);
    stress.body_force = kinematics.cartesian(X, kinematics.body_force(density_, R, tau, dtau_dR));
  }
  stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, now.F);
  return stress;
}

}  // namespace assay
