// SPDX-License-Identifier: BSD-3-Clause
// The exact plane fields at fixed reference points, computed once for each radius of a polar motion, once for all
// points of one whose F is the same everywhere; of the axis-aligned motion by its series.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "harness/exact/box_field.hpp"
#include "harness/exact/exact_solution.hpp"
#include "harness/exact/ring_points.hpp"
#include "harness/motion/frame.hpp"

namespace assay {

/// In-plane components row-major; sigma 11, 12, 21, 22, 33.
struct PlaneState {
  std::array<double, 2> x{}, v{};  ///< [m], [m/s]
  std::array<double, 4> F{};       ///< [1]
  std::array<double, 5> sigma{};   ///< Cauchy stress [Pa]
};

class ExactField {
 public:
  /// X, Y: reference positions [m]; frame: from which a vortex is seen, its angle already in the positions.
  ExactField(std::shared_ptr<const ExactSolution> solution, const Frame& frame, std::span<const double> X,
             std::span<const double> Y);

  /// To the times of which `at` speaks: velocity_time is that of the velocities [s].
  void set_time(double t, double velocity_time);

  /// The same without the stresses, which stay those of the last set_time. It may go back in time, which the history
  /// behind a stress cannot.
  void set_motion(double t, double velocity_time);

  PlaneState at(std::size_t point) const;

  /// P, in-plane components row-major [Pa].
  std::array<double, 4> first_piola_kirchhoff(std::size_t point) const;

  /// Whether the exact motion moves the point.
  bool moves(std::size_t point) const { return points_.ring.empty() || moves_[points_.ring[point]]; }

  /// Of a point's own F: component 21 of r^T F q (17), gamma = 2 eps of the vortex; of other motions det F [1].
  double measure(std::size_t point, const std::array<double, 4>& F) const;

 private:
  /// Of a distinct radius: what its points share, as factors of X and E_z x X, and baseline components.
  struct Ring {
    std::array<double, 2> x{}, v{};
    double cos_alpha = 1, sin_alpha = 0;
    std::array<double, 4> B{};
    std::array<double, 4> tau{};
    std::array<double, 5> sigma{};
  };
  void turn_rings(double t, double velocity_time);
  void stress_rings(double t);
  PlaneState at_ring(std::size_t point) const;
  PlaneState in_box(std::size_t point) const;

  std::shared_ptr<const ExactSolution> solution_;
  Frame frame_;
  double t_ = 0;
  std::vector<double> X_, Y_;
  RingPoints points_;        ///< of a polar motion
  std::vector<bool> moves_;  ///< of each distinct radius
  std::vector<double> parameter_;
  std::vector<Ring> rings_;
  std::optional<BoxField> box_;  ///< of the axis-aligned motion
  double velocity_time_ = 0;
  ExactState now_, then_;  ///< of the origin, where F is the same everywhere
  std::array<double, 4> piola_{};
  std::array<double, 5> sigma_{};
};

}  // namespace assay
