// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/motion.hpp"

#include <algorithm>

#include "harness/motion/radii_of_xi.hpp"

namespace assay {

namespace {

double period(const Vortex& motion) { return motion.amplitude.period; }
double period(const Homogeneous& motion) { return motion.period; }
double period(const RotatingStretch& motion) { return motion.period; }
double period(const DeformationTable& motion) { return motion.last(); }
double period(const TwistingRing& motion) { return motion.period(); }
double period(const AxisAligned& motion) { return motion.amplitude.period; }
double period(const Rigid& motion) { return motion.period; }

}  // namespace

double period_of(const Motion& motion) {
  return std::visit([](const auto& m) { return period(m); }, motion);
}

bool is_homogeneous(const Motion& motion) {
  return !std::holds_alternative<Vortex>(motion) && !std::holds_alternative<TwistingRing>(motion) &&
         !std::holds_alternative<AxisAligned>(motion);
}

bool accelerates(const Motion& motion) {
  const auto* rigid = std::get_if<Rigid>(&motion);
  return !std::holds_alternative<Homogeneous>(motion) && !(rigid && rigid->spin == 0);
}

namespace {

bool about_z(const Vector3& axis) { return axis.x() == 0 && axis.y() == 0; }

bool plane(const Vortex&) { return true; }
bool plane(const TwistingRing&) { return true; }
bool plane(const AxisAligned&) { return true; }
bool plane(const DeformationTable& motion) { return motion.plane(); }
bool plane(const Rigid& motion) { return motion.velocity.z() == 0 && (motion.spin == 0 || about_z(motion.axis)); }
bool plane(const RotatingStretch& motion) {
  return motion.rotate == RotatingStretch::Rotate::none || motion.rotation == 0 || about_z(motion.axis);
}
bool plane(const Homogeneous& motion) {
  const Tensor& F = motion.final;
  return F(0, 2) == 0 && F(1, 2) == 0 && F(2, 0) == 0 && F(2, 1) == 0 && F(2, 2) == 1;
}

}  // namespace

bool is_plane(const Motion& motion) {
  return std::visit([](const auto& m) { return plane(m); }, motion);
}

double own_parameter(const Motion& motion) {
  const auto* straight = std::get_if<Homogeneous>(&motion);
  return straight ? straight->own_parameter() : 1;
}

const Amplitude* amplitude_of(const Motion& motion) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) return &vortex->amplitude;
  if (const auto* ring = std::get_if<TwistingRing>(&motion)) return &ring->twist.amplitude;
  if (const auto* box = std::get_if<AxisAligned>(&motion)) return &box->amplitude;
  return nullptr;
}

std::optional<Annulus> ring_of(const Motion& motion) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) return Annulus{vortex->inner, vortex->outer};
  if (const auto* ring = std::get_if<TwistingRing>(&motion)) return Annulus{ring->inner(), ring->outer()};
  return std::nullopt;
}

const Vortex& turn_of(const Motion& motion) {
  if (const auto* ring = std::get_if<TwistingRing>(&motion)) return ring->twist;
  return std::get<Vortex>(motion);
}

RingKinematics ring_kinematics(const Motion& motion, double R, double t) {
  if (const auto* ring = std::get_if<TwistingRing>(&motion)) return ring->ring(R, t);
  return std::get<Vortex>(motion).ring(R, t);
}

RingParameter ring_parameter(const Motion& motion, double R) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) {
    const Vortex::Profile profile = vortex->profile(R);
    return {profile.xi, profile.xi_prime, profile.h};
  }
  const auto& ring = std::get<TwistingRing>(motion);
  return {std::clamp(R, ring.inner(), ring.outer()), 1, ring.twist.profile(R).h};
}

RingsInMotion::RingsInMotion(const Motion& motion, std::span<const double> radii)
    : amplitude_(turn_of(motion).amplitude), radius_(radii.begin(), radii.end()) {
  const auto* ring = std::get_if<TwistingRing>(&motion);
  if (ring) expansion_ = ring->expansion, period_ = ring->period();
  for (const double R : radii) {
    profile_.push_back(turn_of(motion).profile(R));
    if (ring) radial_.push_back(ring->radial(R));
  }
}

void RingsInMotion::set_time(double t) {
  turn_ = amplitude_.at(t);
  if (!radial_.empty()) widening_ = TwistingRing::widening(t, period_);
}

RingKinematics RingsInMotion::operator[](std::size_t k) const {
  RingKinematics ring = Vortex::ring(radius_[k], profile_[k], turn_);
  if (!radial_.empty()) TwistingRing::widen(ring, expansion_, radial_[k], widening_);
  return ring;
}

std::function<std::vector<double>(double)> radii_of_parameter(const Motion& motion) {
  if (const auto* vortex = std::get_if<Vortex>(&motion)) return RadiiOfXi(*vortex);
  return [](double R) { return std::vector{R}; };
}

}  // namespace assay
