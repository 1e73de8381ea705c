// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/motion.hpp"

#include <algorithm>

#include "harness/motion/kinds/vortex.hpp"

namespace assay {

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
