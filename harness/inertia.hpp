// SPDX-License-Identifier: BSD-3-Clause
// The acceleration of the exact vortex and its gradient at fixed reference points, as a spinning frame sees it; and of
// motions whose F is the same everywhere.
//
// Points move as x = X exp(i beta) in the complex plane, beta = g h + w t with w the frame's spin, so that
//   a = X f,  f = exp(i beta) (i beta.. - beta.^2)                                        (29), [m/s^2]
//   da = dX f + X f' dR,  f' = h' (i g f + exp(i beta) (i g.. - 2 g. beta.))              [1/s^2]
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "harness/motion.hpp"
#include "harness/ring_points.hpp"

namespace assay {

class InertiaField {
 public:
  struct Inertia {
    std::array<double, 2> a{};         ///< [m/s^2]
    std::array<double, 4> gradient{};  ///< d a_i / d X_j, row-major [1/s^2]
  };

  /// spin: w [rad/s]; X, Y: reference positions [m].
  InertiaField(const Vortex& vortex, double spin, std::span<const double> X, std::span<const double> Y);

  /// Of a motion whose F is the same everywhere: a = F.. X.
  InertiaField(const Motion& motion, std::span<const double> X, std::span<const double> Y);

  /// To the time of which `at` speaks.
  void set_time(double t);

  Inertia at(std::size_t point) const;

 private:
  /// f and R f' at a distinct radius: along X and E_z x X [1/s^2].
  struct Factor {
    std::array<double, 2> f{}, slope{};
  };
  Factor factor(const Vortex::Profile& profile, double R, const AmplitudeValue& g, double t) const;

  void set_uniform(double t);

  Vortex vortex_;
  double spin_ = 0;
  std::optional<Motion> uniform_;  // of which F is the same everywhere
  std::vector<double> X_, Y_;
  Inertia of_origin_;
  RingPoints points_;
  std::vector<Vortex::Profile> profile_;  // of each distinct radius
  std::vector<Factor> factor_;
};

}  // namespace assay
