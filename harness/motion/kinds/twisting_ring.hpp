// SPDX-License-Identifier: BSD-3-Clause
// The twisting and expanding ring: the vortex's turn with a change of the radii, so that J != 1 and the ring's faces
// bear tractions. peak = 0 is the expanding ring, expansion = 0 the vortex.
#pragma once

#include "harness/motion/kinds/vortex.hpp"

namespace assay {

/// x = rho e_r(Theta + alpha), alpha = g(t) h(R) as in the vortex, rho = R + e sin(pi t/T) U(R),
/// U = c1 R + c2 R^2 + c3 R^3, c1 = -6 ri ro/d, c2 = 3 (ri + ro)/d, c3 = -2/d, d = ro^2 (ro - 3 ri): U(ro) = 1, and U'
/// is zero at both faces. ro = 3 ri has no such U.
struct TwistingRing {
  Vortex twist;          ///< ri, ro, m, g(t), T
  double expansion = 0;  ///< e, that of the outer radius [m]

  double inner() const { return twist.inner; }
  double outer() const { return twist.outer; }
  double period() const { return twist.amplitude.period; }

  RingRadial radial(double R) const;
  /// e sin(pi t/T) with its rates [m], [m/s], [m/s^2].
  AmplitudeValue widening(double t) const;

  /// The motion of a radius; beyond the faces by the same formula, where h = 0.
  RingKinematics ring(double R, double t) const;

  ExactState at(const Vector3& X, double t) const;

  /// The baseline B(R, t) with the parameter R in [ri, ro].
  Path baseline() const;
};

void fields(auto& archive, TwistingRing& m) { archive(m.twist, m.expansion); }

std::unique_ptr<MotionKind> kind_of(const TwistingRing& motion);

}  // namespace assay
