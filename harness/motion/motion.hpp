// SPDX-License-Identifier: BSD-3-Clause
// The exact motions that a scene can ask for. A new motion is a new alternative here.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "harness/motion/annulus.hpp"
#include "harness/motion/axis_aligned.hpp"
#include "harness/motion/deformation_table.hpp"
#include "harness/motion/homogeneous.hpp"
#include "harness/motion/rigid.hpp"
#include "harness/motion/rotating_stretch.hpp"
#include "harness/motion/twisting_ring.hpp"
#include "harness/motion/vortex.hpp"

namespace assay {

using Motion = std::variant<Vortex, Homogeneous, RotatingStretch, DeformationTable, TwistingRing, AxisAligned, Rigid>;

inline ExactState state_at(const Motion& motion, const Vector3& X, double t) {
  return std::visit([&](const auto& m) { return m.at(X, t); }, motion);
}

inline Path baseline_of(const Motion& motion) {
  return std::visit([](const auto& m) { return m.baseline(); }, motion);
}

/// T [s]; of a table the time of its last row.
double period_of(const Motion& motion);

/// Whether F is the same at all points, so that b = a and P depends on time alone.
bool is_homogeneous(const Motion& motion);

/// Whether any point is ever accelerated.
bool accelerates(const Motion& motion);

/// Whether nothing happens out of the plane: F13 .. F32 = 0, F33 = 1.
bool is_plane(const Motion& motion);

/// The parameter of the baseline at which a motion whose F is the same everywhere runs.
double own_parameter(const Motion& motion);

/// g(t) of a motion that has one, else null.
const Amplitude* amplitude_of(const Motion& motion);

/// The ring in which the motion takes place; absent where it is not polar.
std::optional<Annulus> ring_of(const Motion& motion);

// Of a polar motion, the vortex or the twisting ring, at a radius R [m]:

/// The turn alpha = g(t) h(R) alone, without a change of the radii.
const Vortex& turn_of(const Motion& motion);

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
  double expansion_ = 0, period_ = 1;  ///< of a twisting ring; 0: none
  Amplitude amplitude_;
  AmplitudeValue turn_, widening_;
  std::vector<double> radius_;
  std::vector<Vortex::Profile> profile_;
  std::vector<TwistingRing::Radial> radial_;  ///< of a twisting ring
};

/// The parameter of the baseline and its slope: xi and xi' of the vortex; R and 1 of the twisting ring; with h.
struct RingParameter {
  double value = 0, slope = 0, h = 0;
};
RingParameter ring_parameter(const Motion& motion, double R);

/// The inverse of it: the radii at which the parameter has a value, ascending [m].
std::function<std::vector<double>(double)> radii_of_parameter(const Motion& motion);

}  // namespace assay
