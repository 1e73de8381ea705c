// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/frame.hpp"

namespace assay {

namespace {

/// E_z x a.
Vector3 across(const Vector3& a) { return {-a.y(), a.x(), 0}; }

}  // namespace

Vector3 Frame::coriolis_and_centrifugal(const ExactState& state) const {
  return 2 * spin * across(state.v) + spin * spin * across(across(state.x));
}

ExactState Frame::seen(const ExactState& state, double t) const {
  const Tensor R = rotation(t);
  ExactState out;
  out.x = R * state.x + velocity * t;
  out.v = R * (state.v + spin * across(state.x)) + velocity;
  out.a = R * (state.a + coriolis_and_centrifugal(state));
  out.F = R * state.F * rotation(0).transpose();
  Tensor W = Tensor::Zero();  // W a = E_z x a
  W(0, 1) = -1, W(1, 0) = 1;
  out.F_rate = R * (state.F_rate + spin * W * state.F) * rotation(0).transpose();
  return out;
}

ExactStress Frame::seen(const ExactStress& stress, const ExactState& state, double t) const {
  const Tensor R = rotation(t);
  ExactStress out;
  out.first_piola_kirchhoff = R * stress.first_piola_kirchhoff * rotation(0).transpose();
  out.cauchy = R * stress.cauchy * R.transpose();
  out.body_force = R * (stress.body_force + coriolis_and_centrifugal(state));
  return out;
}

}  // namespace assay
