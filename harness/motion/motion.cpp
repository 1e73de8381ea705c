// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/motion.hpp"

#include <algorithm>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/rising_root.hpp"

namespace assay {

namespace {

/// By Newton's method from X; absent where it does not converge.
std::optional<Vector3> refined_reference(const MotionKind& motion, const Vector3& x, double t, Vector3 X) {
  constexpr int most_steps = 20;
  constexpr double converged = 1e-10;  // of the size of X and x: the step after it would be one of rounding
  for (int k = 0; k < most_steps; ++k) {
    const ExactState now = motion.at(X, t);
    const Vector3 step = now.F.inverse() * (x - now.x);
    if (!step.allFinite()) return std::nullopt;
    X += step;
    if (step.norm() <= converged * (X.norm() + x.norm())) return X;
  }
  return std::nullopt;
}

}  // namespace

// What Newton's method finds is the point, for a motion takes no two points to one place. It begins at the point that
// was at x a while before: at rest x itself.
std::optional<Vector3> MotionKind::reference_of(const Vector3& x, double t) const {
  constexpr double shortest = 1e-3;  // of t
  Vector3 X = x;
  for (double known = 0, step = 1; known < 1;) {
    const double next = std::min(1.0, known + step);
    if (const auto found = refined_reference(*this, x, next * t, X))
      X = *found, known = next;
    else if ((step *= 0.5) < shortest)
      return std::nullopt;
  }
  return X;
}

std::optional<Vector3> PolarMotion::turned_back(const Vector3& x, double t) const {
  constexpr double edge_rounding = 5e-10;  // of a radius: on an edge is in the ring
  const double rho = std::hypot(x.x(), x.y());
  double R = rho;
  if (widens()) {  // rho(R) rises
    const double w = widening(t).value, lower = ring().inner * (1 - edge_rounding),
                 upper = ring().outer * (1 + edge_rounding);
    const auto beyond = [&](double at) {
      const RingRadial u = radial(at);
      return std::pair{at + w * u.U - rho, 1 + w * u.slope};
    };
    if (!(beyond(lower).first <= 0 && beyond(upper).first >= 0)) return std::nullopt;
    R = rising_root(lower, upper, rho, beyond);
  }
  Vector3 X = rotation_about_z(-turn().at(t).value * profile(R).h) * x;  // (5)
  if (widens()) X.head<2>() *= R / rho;
  return X;
}

Motion::Motion() : Motion(Vortex{}) {}

std::optional<Annulus> ring_of(const Motion& motion) {
  const PolarMotion* polar = motion->polar();
  return polar ? std::optional(polar->ring()) : std::nullopt;
}

RingKinematics ring_kinematics(const Motion& motion, double R, double t) {
  const PolarMotion& polar = *motion->polar();
  RingKinematics ring = RingKinematics::turned(R, polar.profile(R), polar.turn().at(t));
  if (polar.widens()) ring.widen(polar.radial(R), polar.widening(t));
  return ring;
}

RingParameter ring_parameter(const Motion& motion, double R) {
  const PolarMotion& polar = *motion->polar();
  const RingProfile profile = polar.profile(R);
  if (!polar.widens()) return {profile.xi, profile.xi_prime, profile.h};
  const Annulus ring = polar.ring();
  return {std::clamp(R, ring.inner, ring.outer), 1, profile.h};
}

RingsInMotion::RingsInMotion(const Motion& motion, std::span<const double> radii)
    : motion_(motion), radius_(radii.begin(), radii.end()) {
  const PolarMotion& polar = *motion->polar();
  for (const double R : radii) {
    profile_.push_back(polar.profile(R));
    if (polar.widens()) radial_.push_back(polar.radial(R));
  }
}

void RingsInMotion::set_time(double t) {
  const PolarMotion& polar = *motion_->polar();
  turn_ = polar.turn().at(t);
  widening_ = polar.widening(t);
}

RingKinematics RingsInMotion::operator[](std::size_t k) const {
  RingKinematics ring = RingKinematics::turned(radius_[k], profile_[k], turn_);
  if (!radial_.empty()) ring.widen(radial_[k], widening_);
  return ring;
}

}  // namespace assay
