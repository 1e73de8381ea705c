// SPDX-License-Identifier: BSD-3-Clause
// The body force of the vortex as a spinning frame sees it: b' = Q(w t) (b + 2 w x v + w x (w x x)).
//
// The vortex is the same after a turn about its axis, so b at X' = R(0) X is already that of the body turned by the
// frame's angle; what is left is the turn by w t. Its points move as x = X exp(i alpha) in the complex plane, with
// v = i omega x, and the added terms are x (-2 omega w - w^2).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/exact/reference_domain.hpp"
#include "harness/exact/ring_moments.hpp"
#include "harness/exact/ring_points.hpp"
#include "harness/motion/motion.hpp"

namespace assay {

class FrameForce {
 public:
  /// motion: whose radii do not change; spin: w [rad/s]; X, Y: reference positions at which b is given [m].
  FrameForce(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y);

  /// b is given as the mean over each domain, and X, Y are the domains' centroids: the added terms are means too.
  FrameForce(const Motion& motion, double spin, std::span<const double> X, std::span<const double> Y,
             const ReferenceDomains& domains);

  /// Replaces b [m/s^2] of each particle by b'.
  void apply(double t, std::span<double> b_x, std::span<double> b_y);

 private:
  Point factor(const AmplitudeValue& g, double h) const;
  void add_at_points(const AmplitudeValue& g, std::span<double> b_x, std::span<double> b_y);
  void add_means(const AmplitudeValue& g, std::span<double> b_x, std::span<double> b_y);

  Motion motion_;
  double spin_;
  std::vector<double> X_, Y_;
  RingPoints points_;                   // of terms taken at the points
  std::optional<RingMoments> moments_;  // of means
  std::vector<double> node_h_;          // at the radial nodes of these
  std::vector<ReferenceDomains::Place> places_;
  std::vector<double> volume_;  // of each shape [m^3]
  std::vector<Point> factor_;   // at each distinct radius, or radial node: along X and E_z x X [1/s^2]
  std::vector<Point> force_;    // of each shape [m/s^2]
};

}  // namespace assay
