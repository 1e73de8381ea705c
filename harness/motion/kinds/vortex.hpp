// SPDX-License-Identifier: BSD-3-Clause
// The generalized vortex, section 2 of the paper: circular motion, simple shear with rotation everywhere.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// x = Q(alpha) X (3), alpha = g(t) h(R) (5), h = (1 - s^2)^m with s = (R - (ri+ro)/2) / ((ro-ri)/2) inside the
/// ring, 0 outside. m = 2, ri = .75, ro = 1.25 is the h of section 2.4.
struct Vortex {
  double inner = 0.75;    ///< ri, the paper's a [m]
  double outer = 1.25;    ///< ro, the paper's b [m]
  int profile_power = 2;  ///< m
  Amplitude amplitude;

  /// At the radii ri and ro themselves: the limit from inside.
  RingProfile profile(double R) const;

  /// Whether the exact motion moves the point: ri < R < ro.
  bool moves(const Vector3& X) const;

  /// Position (3), velocity (28), acceleration (29) and deformation gradient (12) of reference point X at time t.
  ExactState at(const Vector3& X, double t) const;

  /// rho = R, alpha = g h, at a radius.
  RingKinematics ring(double R, double t) const { return RingKinematics::turned(R, profile(R), amplitude.at(t)); }

  /// Over which the profile changes: half the width of the ring, less of a high power [m].
  double length() const { return profile_length(0.5 * (outer - inner), profile_power); }

  /// Smallest and largest xi in the ring.
  Interval xi_range() const;

  /// The baseline F = I + 2 g(t) xi E2 E1 (16) with parameter xi.
  Path baseline() const;
};

void fields(auto& archive, Vortex& m) { archive(m.inner, m.outer, m.profile_power, m.amplitude); }

/// Radii between which xi(R) is monotone, ascending, with ri and ro [m].
std::vector<double> turning_radii(const Vortex& vortex);

/// The inverse of xi(R) (13), which has several values.
class RadiiOfXi {
 public:
  explicit RadiiOfXi(const Vortex& vortex) : vortex_(vortex), turning_(turning_radii(vortex)) {}

  /// Every radius of the ring at which xi(R) goes through `xi`, ascending [m].
  std::vector<double> operator()(double xi) const;

 private:
  Vortex vortex_;
  std::vector<double> turning_;
};

std::unique_ptr<MotionKind> kind_of(const Vortex& motion);

/// The keys of a ring that turns, but for those of its amplitude.
void ring_keys(Keys& keys, Vortex& motion);

/// Whether the inner radius is the smaller one.
std::optional<MotionFault> fault_of_radii(const Annulus& ring, const MotionUse& use);

}  // namespace assay
