// SPDX-License-Identifier: BSD-3-Clause
// The acceleration of a polar motion and its gradient at fixed reference points, as a spinning frame sees it; and of
// motions whose F is the same everywhere.
//
// Points move as x = E_R rho exp(i beta) in the complex plane, beta = alpha + w t with w the frame's spin, so that
//   a = X f,  f = exp(i beta) z / R,  z = a_r + i a_theta = rho (i beta.. - beta.^2) + rho.. + 2 i rho. beta.
//   da = dX f + X f' dR,  R f' = exp(i beta) (z' + i beta' z - z/R)                       [1/s^2]
// of which f = exp(i beta) (i beta.. - beta.^2) is the vortex's (29).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "harness/exact/ring_points.hpp"
#include "harness/motion/motion.hpp"

namespace assay {

class InertiaField {
 public:
  struct Inertia {
    std::array<double, 2> a{};         ///< [m/s^2]
    std::array<double, 4> gradient{};  ///< d a_i / d X_j, row-major [1/s^2]
  };

  /// motion: polar, axis-aligned, or one whose F is the same everywhere, a = F.. X; spin: w of a polar one [rad/s]; X,
  /// Y: reference positions [m].
  InertiaField(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y);

  /// To the time of which `at` speaks.
  void set_time(double t);

  Inertia at(std::size_t point) const;

 private:
  /// f and R f' at a distinct radius: along X and E_z x X [1/s^2].
  struct Factor {
    std::array<double, 2> f{}, slope{};
  };
  Factor factor(double R, RingKinematics ring, double t) const;

  void set_uniform(double t);

  Motion motion_;
  double spin_ = 0, t_ = 0;
  bool in_box_ = false;        // axis-aligned
  std::vector<double> X_, Y_;  // of a motion that is not polar
  Inertia of_origin_;
  RingPoints points_;    // of a polar one
  RingsInMotion rings_;  // at each distinct radius
  std::vector<Factor> factor_;
};

}  // namespace assay
