// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact_solution.hpp"

#include <cmath>

namespace assay {

void ExactSolution::baseline_stress(double R, double t, Tensor& tau, Tensor& dtau_dR) const {
  const RingParameter xi = ring_parameter(motion_, R);
  (*response())->at(xi.value, t, tau, dtau_dR);
  dtau_dR *= xi.slope;  // (21), corrected
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
