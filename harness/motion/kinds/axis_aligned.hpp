// SPDX-License-Identifier: BSD-3-Clause
// Axis-aligned displacement in the unit box, Wallstedt and Guilkey [12], in the plane and in space, and its
// one-dimensional version, the bar.
#pragma once

#include "harness/motion/motion_kind.hpp"

namespace assay {

/// u_i = A s_i sin(pi X_i) sin(c pi t) with a factor s_i for each axis; of the bar s = (1, 0, 0). Lengths in metres:
/// X_i stands for X_i/1 m. Its symmetry planes X_i = .., -1, 0, 1, .. stand still and bear no shear.
struct AxisAligned {
  /// Within these c and T = 1/c are both numbers of full precision [m/s].
  static constexpr double least_wave_speed = 1e-300, most_wave_speed = 1e300;

  Amplitude amplitude;                  ///< A sin(pi t/T), |A s_i| < 1/pi [m], T = 1/c [s]
  bool one_dimensional = false;         ///< the bar
  bool given_speed = false;             ///< c is the scene's own; else that of a bar, sqrt(E/rho0)
  std::optional<Vector3> factors = {};  ///< s, not of the bar; in the plane the third is 0 [1]
  bool in_space = false;                ///< in three dimensions, where the usual factors are others

  double wave_speed() const { return 1 / amplitude.period; }  ///< c [m/s]

  /// Of the bar (1, 0, 0), else the factors; where none are given (1, -1, 0), in space (1, -1, 1/2) [1].
  Vector3 s() const;

  ExactState at(const Vector3& X, double t) const;

  /// The inverse of it, axis by axis: X_i + s_i g sin(pi X_i)/pi = x_i rises with X_i.
  Vector3 reference_of(const Vector3& x, double t) const;

  /// d a / d X, diagonal [1/s^2].
  Tensor acceleration_gradient(const Vector3& X, double t) const;

  /// F_ii = 1 + s_i g cos(pi X_i) with g = pi A sin(c pi t): the family with the parameter cos(pi X), from -1 to 1, at
  /// one cos(pi Y) and one cos(pi Z) [1]. Of the bar uniaxial strain (38).
  Path section(double cosine_of_Y, double cosine_of_Z = 1) const;
  Path baseline() const { return section(1); }
};

void fields(auto& archive, AxisAligned& m) {
  archive(m.amplitude, m.one_dimensional, m.given_speed, m.factors, m.in_space);
}

std::unique_ptr<MotionKind> kind_of(const AxisAligned& motion);

}  // namespace assay
