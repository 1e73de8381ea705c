// SPDX-License-Identifier: BSD-3-Clause
// Rigid motion: x = Q(spin t) X + velocity t.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

struct Rigid {
  Vector3 velocity = Vector3::Zero();  ///< [m/s]
  double spin = 0;                     ///< about the axis through the origin [rad/s]
  Vector3 axis{0, 0, 1};               ///< not zero; its length does not matter
  double period = 1;                   ///< T [s]

  ExactState at(const Vector3& X, double t) const;

  /// F = Q(spin t), the same for every value of the parameter.
  Path baseline() const;
};

void fields(auto& archive, Rigid& m) { archive(m.velocity, m.spin, m.axis, m.period); }

std::unique_ptr<MotionKind> kind_of(const Rigid& motion);

}  // namespace assay
