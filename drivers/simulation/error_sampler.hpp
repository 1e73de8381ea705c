// SPDX-License-Identifier: BSD-3-Clause
// The error of a running simulation against the exact motion.
#pragma once

#include "drivers/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/ring_points.hpp"
#include "mpm/state.hpp"

namespace assay::drivers {

/// Exact fields of the vortex at the particles' reference points, computed once for each radius and time. To a frame
/// that spins every ring turns by spin t more; its angle is in the reference points.
class ErrorSampler {
 public:
  ErrorSampler(const Problem& problem, std::shared_ptr<const Response> response, const mpm::State<2>& state);

  /// Errors of displacement, velocity, F, J and Cauchy stress at time t.
  /// velocity_time: to which the particles' velocities belong [s].
  ErrorSample sample(const mpm::State<2>& state, double t, double velocity_time);

  /// |u - u_exact| of each particle at the time of the last sample [m].
  const std::vector<double>& displacement_error() const { return displacement_error_; }
  /// Shear gamma of each particle's own F in its ring's baseline, component 21 of r^T F q (17), at that time [1].
  const std::vector<double>& shear() const { return shear_; }
  /// L2 norm of the exact displacement at that time, over the particles that move, in the body's own frame [m].
  double exact_displacement() const { return exact_displacement_; }

 private:
  struct RingState {
    double cos_alpha = 1, sin_alpha = 0, gamma = 0;
    double omega_cos = 0, omega_sin = 0;  ///< omega times cosine and sine of alpha, at the time of the velocities
    double sigma[5] = {};                 ///< baseline Cauchy stress 11, 12, 21, 22, 33
  };
  void update_rings(double t);
  void update_velocities(double t);

  Vortex vortex_;
  Frame frame_;
  std::shared_ptr<const Response> response_;
  RingPoints points_;
  std::vector<double> xi_;
  std::vector<bool> moves_;  ///< of each distinct radius
  std::vector<RingState> rings_;
  std::size_t held_;
  std::vector<double> displacement_error_, shear_;
  double exact_displacement_ = 0;
};

/// The figures of result.json from the history of samples; half_period: T/2 [s].
ErrorFigures figures_of(const std::vector<ErrorSample>& history, double half_period, double end,
                        double largest_displacement);

}  // namespace assay::drivers
