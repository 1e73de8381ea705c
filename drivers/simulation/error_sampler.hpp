// SPDX-License-Identifier: BSD-3-Clause
// The error of a running simulation against the exact motion.
#pragma once

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/exact/space_instant.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

template <int Dim>
class ErrorSampler {
 public:
  ErrorSampler(const ProblemIn<Dim>& problem, const ExactSolutionPtr& solution, const mpm::State<Dim>& state);

  /// Errors of displacement, velocity, F, J and Cauchy stress at time t.
  /// velocity_time: to which the particles' velocities belong [s].
  ErrorSample sample(const mpm::State<Dim>& state, double t, double velocity_time);

  /// |u - u_exact| of each particle at the time of the last sample [m]; none where the scene shows no particles.
  const std::vector<double>& displacement_error() const { return displacement_error_; }
  /// ExactInstant::measure of each particle's own F at that time: shear of the vortex, else J [1].
  const std::vector<double>& measure() const { return measure_; }
  /// L2 norm of the exact displacement at that time, over the particles that move, in the body's own frame [m].
  double exact_displacement() const { return exact_displacement_; }

 private:
  std::unique_ptr<InstantOf<Dim>> now_;       ///< as the scene's frame sees it
  std::unique_ptr<InstantOf<Dim>> velocity_;  ///< the same at the time of the particles' velocities
  std::size_t held_;
  double stress_unit_;  ///< a power of two near rho c^2 [Pa]: squares of errors neither overflow nor vanish
  std::vector<double> displacement_error_, measure_;
  double exact_displacement_ = 0;
};

/// The figures of result.json from the history of samples; half_period: T/2 [s].
ErrorFigures figures_of(const std::vector<ErrorSample>& history, double half_period, double end,
                        double largest_displacement);

}  // namespace assay::drivers
