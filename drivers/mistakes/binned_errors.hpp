// SPDX-License-Identifier: BSD-3-Clause
// The errors of many particles as means over parts of the body: rings of a polar motion, cells of a box. Of a ring the
// errors are turned back first: along e_r and e_theta of the exact motion.
#pragma once

#include <array>
#include <vector>

#include "harness/motion/motion.hpp"

namespace assay::drivers {

/// How the square of the errors is distributed over waves around the axis, cos(m Theta) and sin(m Theta), m = 0 .. 8.
inline constexpr std::size_t waves = 9;

inline double dot_in_plane(const Vector3& a, const Vector3& b) { return a.x() * b.x() + a.y() * b.y(); }

class BinnedErrors {
 public:
  /// Of a motion in the plane; lower, upper: corners of a body that is a box [m].
  BinnedErrors(const Motion& of, const std::array<double, 2>& lower, const std::array<double, 2>& upper);

  void begin_frame(double t);
  /// error: x - x_exact [m]; weight: its volume, or 1.
  void add(const Vector3& X, const Vector3& error, const Vector3& x_exact, double weight);
  /// Of a particle that the exact motion does not move; of those on the faces of a ring nothing is noted.
  void add_at_rest(const Vector3& X, const Vector3& error);
  /// After the last frame.
  void finish();

  std::vector<double> t;                ///< [s]
  std::vector<Vector3> X;               ///< of each bin: a point whose radius, or place, is its particles' mean [m]
  std::vector<double> weight;           ///< its share of the body; 0 without particles
  std::vector<std::vector<Vector3>> e;  ///< [frame][bin]: mean error [m]
  std::vector<double> square;           ///< [frame]: mean square of all errors, those from the bins' means too [m^2]
  std::vector<double> motion;           ///< [frame]: mean square of the exact displacement [m^2]
  std::vector<std::array<double, waves>> of_wave;  ///< [frame]: its parts; of a ring
  bool rests_outside = true, any_outside = false;  ///< of the body around a ring

 private:
  std::size_t bin_of(const Vector3& at) const;
  bool ring_ = false;
  std::array<double, 2> lower_{}, width_{};
  std::array<std::size_t, 2> count_{};
  struct Sums {
    double weight = 0, square = 0, motion = 0;
    Vector3 e = Vector3::Zero(), X = Vector3::Zero();
    double R = 0;
    std::array<std::array<double, 4>, waves> of_wave{};  ///< e_r, e_theta with cos and sin
  };
  std::vector<Sums> now_;
  double at_rest_ = 0, moving_ = 0;  ///< largest errors [m]
  void end_frame();
};

}  // namespace assay::drivers
