// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/frame.hpp"

#include <Eigen/Geometry>

#include "harness/numeric/norms.hpp"

namespace assay {

Vector3 Frame::unit_axis() const { return unit_along(axis); }

Tensor Frame::rotation(double t) const {
  const Vector3 n = unit_axis();
  if (n == Vector3::UnitZ()) return rotation_about_z(angle + spin * t);
  return Eigen::AngleAxisd(angle + spin * t, n).toRotationMatrix();
}

Vector3 Frame::coriolis_and_centrifugal(const ExactState& state) const {
  const Vector3 n = unit_axis();
  return 2 * spin * n.cross(state.v) + spin * spin * n.cross(n.cross(state.x));
}

// R commutes with the products with w, whose axis it keeps.
ExactState Frame::seen(const ExactState& state, double t) const {
  const Tensor R = rotation(t), R_0 = rotation(0).transpose();
  const Vector3 w = spin * unit_axis();
  ExactState out;
  out.x = R * state.x + velocity * t;
  out.v = R * (state.v + w.cross(state.x)) + velocity;
  out.a = R * (state.a + coriolis_and_centrifugal(state));
  out.F = R * state.F * R_0;
  Tensor rate = state.F_rate;
  for (int j = 0; j < 3; ++j) rate.col(j) += w.cross(state.F.col(j));
  out.F_rate = R * rate * R_0;
  return out;
}

ExactStress Frame::seen(const ExactStress& stress, const ExactState& state, double t) const {
  const Tensor R = rotation(t);
  ExactStress out;
  out.first_piola_kirchhoff = R * stress.first_piola_kirchhoff * rotation(0).transpose();
  out.cauchy = R * stress.cauchy * R.transpose();
  out.body_force = R * (stress.body_force + coriolis_and_centrifugal(state));
  out.static_force = R * stress.static_force;
  return out;
}

}  // namespace assay
