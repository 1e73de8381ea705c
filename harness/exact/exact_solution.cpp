// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/exact_solution.hpp"

#include <cmath>

#include "harness/exact/body_force.hpp"

namespace assay {

/// P and b of a polar motion, (20) and (31).
ExactStress ExactSolution::ring_stress(const Vector3& X, double t) const {
  const double R = std::hypot(X.x(), X.y());
  const RingKinematics kinematics = ring_kinematics(motion_, R, t);
  Tensor tau, dtau_dxi;
  (*response())->at(ring_parameter(motion_, R).value, t, tau, dtau_dxi);
  const PolarMotion& polar = *motion_->polar();
  const Polar b = polar.widens() ? kinematics.body_force(density_, R, tau, dtau_dxi)
                                 : assay::body_force(polar.profile(R), polar.turn().at(t), density_, R, tau, dtau_dxi);
  return {kinematics.first_piola_kirchhoff(X, tau), Tensor::Zero(), kinematics.cartesian(X, b)};
}

ExactStress ExactSolution::stress(const Vector3& X, double t) const {
  const ExactState now = state(X, t);
  ExactStress stress;
  if (homogeneous()) {
    stress.first_piola_kirchhoff = (*homogeneous())->at(t);
    stress.body_force = now.a;
  } else if (box()) {
    (*box())->set_time(t);
    const BoxStress::Local local = (*box())->at(X.x(), X.y());
    for (int d = 0; d < 3; ++d) stress.first_piola_kirchhoff(d, d) = local.piola[static_cast<std::size_t>(d)];
    stress.body_force = now.a - Vector3(local.along_X[0], local.along_Y[1], 0) / density_;
  } else {
    stress = ring_stress(X, t);
  }
  stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, now.F);
  return stress;
}

}  // namespace assay
