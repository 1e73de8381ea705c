// SPDX-License-Identifier: BSD-3-Clause
// An exact motion that a scene can ask for. A new one is a new file in harness/motion/kinds.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// A value: copies are independent.
class Motion {
 public:
  Motion();  ///< the vortex of the paper

  /// Of a struct of harness/motion/kinds.
  template <class Struct>
  requires requires(const Struct& motion) { kind_of(motion); }
  Motion(const Struct& motion) : kind_(kind_of(motion)) {}

  Motion(const Motion& other) : kind_(other.kind_->copy()) {}
  Motion(Motion&& other) = default;
  Motion& operator=(Motion other) {
    kind_.swap(other.kind_);
    return *this;
  }

  const MotionKind* operator->() const { return kind_.get(); }
  MotionKind* operator->() { return kind_.get(); }

  /// The struct that it was made of; null where that is another.
  template <class Struct>
  const Struct* as() const {
    return static_cast<const Struct*>(kind_->as(typeid(Struct)));
  }
  template <class Struct>
  Struct* as() {
    return static_cast<Struct*>(kind_->as(typeid(Struct)));
  }

 private:
  std::unique_ptr<MotionKind> kind_;
};

/// Whether F depends on cos(pi X) and cos(pi Y), as in the unit box.
inline bool is_box(const Motion& motion) { return !motion->polar() && !motion->is_homogeneous(); }

/// Whether the motion turns a ring whose radii stay, so that what lies outside it is at rest and the baseline is simple
/// shear.
inline bool is_vortex(const Motion& motion) { return motion->polar() && !motion->polar()->widens(); }

/// The ring in which the motion takes place; absent where it is not polar.
std::optional<Annulus> ring_of(const Motion& motion);

// Of a polar motion, the vortex or the twisting ring, at a radius R [m]:

/// rho, alpha and their derivatives.
RingKinematics ring_kinematics(const Motion& motion, double R, double t);

/// The same at many radii, of which all that does not change with time is computed once.
class RingsInMotion {
 public:
  RingsInMotion() = default;
  RingsInMotion(const Motion& motion, std::span<const double> radii);
  void set_time(double t);
  std::size_t size() const { return radius_.size(); }
  double radius(std::size_t k) const { return radius_[k]; }
  RingKinematics operator[](std::size_t k) const;  ///< at the time that was set

 private:
  Motion motion_;
  AmplitudeValue turn_, widening_;
  std::vector<double> radius_;
  std::vector<RingProfile> profile_;
  std::vector<RingRadial> radial_;  ///< empty where no radius changes
};

/// The parameter of the baseline and its slope: xi and xi' of the vortex; R and 1 of the twisting ring; with h.
struct RingParameter {
  double value = 0, slope = 0, h = 0;
};
RingParameter ring_parameter(const Motion& motion, double R);

}  // namespace assay
