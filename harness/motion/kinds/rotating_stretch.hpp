// SPDX-License-Identifier: BSD-3-Clause
// Homogeneous stretch under a rotation about any axis: F = Q(t) U(t), x = F X.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// U = diag(Lambda, 1, 1) + k (Lambda - 1)/a E1 E2, Q the rotation by angle(t) about the axis. With the smooth ramp
/// q(u) = u^3 (10 - 15 u + 6 u^2), held at 1 for u > 1:
/// none, simultaneous: Lambda = 1 + a sin^2(pi t/T), angle = 0 or beta q(t/T);
/// after: Lambda = 1 + a q(2 t/T), angle = beta q(2 t/T - 1).
struct RotatingStretch {
  enum class Rotate { none, simultaneous, after };
  friend constexpr std::array<const char*, 3> names_of(Rotate) { return {"none", "simultaneous", "after"}; }
  double stretch = 0;     ///< a > -1 [1]
  double shear = 0;       ///< k [1]
  double rotation = 0;    ///< beta [rad]
  Vector3 axis{0, 0, 1};  ///< not zero; its length does not matter
  Rotate rotate = Rotate::simultaneous;
  double period = 1;  ///< T [s]

  /// x = F X, v = F' X, a = F'' X.
  ExactState at(const Vector3& X, double t) const;

  /// The scene's own path is xi = 1; xi in [0, 1] scales the stretch, Lambda = 1 + xi a s(t) with the shear
  /// k (Lambda - 1)/a, and leaves the rotation as it is.
  Path baseline() const;
};

void fields(auto& archive, RotatingStretch& m) { archive(m.stretch, m.shear, m.rotation, m.axis, m.rotate, m.period); }

std::unique_ptr<MotionKind> kind_of(const RotatingStretch& motion);

}  // namespace assay
