// SPDX-License-Identifier: BSD-3-Clause
// The frame from which a motion is seen: turned, spinning, in uniform flight.
#pragma once

#include <vector>

#include "harness/motion/exact_state.hpp"

namespace assay {

/// With R(t) the rotation by angle + spin t about an axis through the origin, and X' = R(0) X,
///   x'(X', t) = R(t) x(R(0)^T X', t) + velocity t.
/// The angle is a change of basis: the body is turned against the grid. Spin and velocity are a change of frame.
struct Frame {
  double angle = 0;                    ///< [rad]
  double spin = 0;                     ///< w, of the observed motion against the body's [rad/s]
  Vector3 velocity = Vector3::Zero();  ///< c [m/s]
  Vector3 axis{0, 0, 1};               ///< not zero; its length does not matter; in the plane E_z

  void keys(auto& key) {
    key("angle", "angle by which body and motion are rotated against the grid, about the axis", angle, {.unit = "rad"});
    key("spin", "angular velocity w: the whole motion rotates by a further angle w t", spin, {.unit = "rad/s"});
    std::vector<double> c{velocity.x(), velocity.y()};
    if (velocity.z() != 0) c.push_back(velocity.z());
    if (key("velocity", "velocity of the whole motion; with dimension: 3 also three numbers", c, {.unit = "m/s"}))
      velocity << c[0], c[1], c.size() == 3 ? c[2] : 0;
    key("axis", "axis of angle and spin through the origin, any length; another than E_z needs dimension: 3", axis,
        {.derived = "[0, 0, 1]", .shown = axis != Vector3::UnitZ()});
  }

  bool moves() const { return spin != 0 || velocity != Vector3::Zero(); }

  Vector3 unit_axis() const;

  Tensor rotation(double t) const;

  /// X = R(0)^T X' [m].
  Vector3 body_point(const Vector3& X) const { return rotation(0).transpose() * X; }

  /// x = R(t)^T (x' - velocity t) [m].
  Vector3 body_position(const Vector3& x, double t) const { return rotation(t).transpose() * (x - velocity * t); }

  /// 2 w x v + w x (w x x), w along the axis, of a point of the body, along the body's axes [m/s^2].
  Vector3 coriolis_and_centrifugal(const ExactState& state) const;

  /// x', v' = R (v + w x x) + c, a' = R (a + 2 w x v + w x (w x x)), F' = R(t) F R(0)^T.
  ExactState seen(const ExactState& state, double t) const;

  /// P' = R(t) P R(0)^T, sigma' = R sigma R^T, b' = R (b + 2 w x v + w x (w x x)), without inertia R b alone; state: of
  /// the body's own motion.
  ExactStress seen(const ExactStress& stress, const ExactState& state, double t) const;
};

}  // namespace assay
