// SPDX-License-Identifier: BSD-3-Clause
// Axis-aligned displacement in the unit box, Wallstedt and Guilkey [12], and its one-dimensional version, the bar.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// u_x = A sin(pi X) sin(c pi t), u_y = A sin(pi Y) sin(c pi t + pi); of the bar u_y = 0. Lengths in metres: X, Y stand
/// for X/1 m, Y/1 m. Its symmetry planes X, Y = .., -1, 0, 1, .. stand still and bear no shear.
struct AxisAligned {
  /// Within these c and T = 1/c are both numbers of full precision [m/s].
  static constexpr double least_wave_speed = 1e-300, most_wave_speed = 1e300;

  Amplitude amplitude;           ///< A sin(pi t/T), |A| < 1/pi [m], T = 1/c [s]
  bool one_dimensional = false;  ///< the bar
  bool given_speed = false;      ///< c is the scene's own; else that of a bar, sqrt(E/rho0)

  double wave_speed() const { return 1 / amplitude.period; }  ///< c [m/s]

  ExactState at(const Vector3& X, double t) const;

  /// d a / d X, diagonal [1/s^2].
  Tensor acceleration_gradient(const Vector3& X, double t) const;

  /// F = diag(1 + g cos(pi X), 1 - g cos(pi Y), 1) with g = pi A sin(c pi t): the family with the parameter cos(pi X),
  /// from -1 to 1, at one cos(pi Y) [1]. Of the bar uniaxial strain (38).
  Path section(double cosine_of_Y) const;
  Path baseline() const { return section(1); }
};

void fields(auto& archive, AxisAligned& m) { archive(m.amplitude, m.one_dimensional, m.given_speed); }

std::unique_ptr<MotionKind> kind_of(const AxisAligned& motion);

}  // namespace assay
