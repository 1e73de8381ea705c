// SPDX-License-Identifier: BSD-3-Clause
// How long a run's steps are.
#pragma once

#include <algorithm>

#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

/// Into the problem: the fastest waves on the baseline path, what artificial viscosity makes of them, and the fastest
/// particle of the exact motion, as the scene's frame sees it.
template <int Dim>
void find_speeds(ProblemIn<Dim>& problem);

/// What crosses cells of the grid the fastest [m/s]: a wave and the particle that carries it, or, of the total
/// formulation, a wave across the reference configuration, where that is faster.
double fastest_signal(const PosedScene& problem);

/// The fastest of the exact motion, in the body's own frame, or of the initial velocity [m/s].
double fastest_of_motion(const Scene& scene);

/// By what factor a viscous pressure shortens the stable step, with waves of that speed [m/s] and volumes that shrink
/// at that rate [1/s]: (Q + sqrt(Q^2 + c^2)) / c with Q = C1 c + C2 h |tr D|, of central differences that take the
/// velocity of half a step before (Benson 1992, doi:10.1016/0045-7825(92)90042-I). 1 without viscosity.
double viscous_shortening(const PosedScene& problem, double wave, double shrinking);

/// The fastest that the exact motion shrinks volumes, -tr D [1/s]; at least 0.
double fastest_shrinking(const Scene& scene);

/// dt and the number of steps, from the key that fixes them or the Courant number and both speeds. Throws InputError.
void plan_steps(PosedScene& problem);

/// Steps as long as the particles allow now, in place of equal ones planned by the exact motion.
template <int Dim>
class TimeControl {
 public:
  TimeControl(const ProblemIn<Dim>& problem, const mpm::State<Dim>& state);

  /// End of the step that begins at t [s]: by the Courant number of the fastest wave and particle, which are looked
  /// for every few steps; T/2, its multiples and the end of the run are met.
  double next(const mpm::State<Dim>& state, double t);

  /// The fastest wave across the grid, when it was last looked for [m/s].
  double wave_speed() const { return std::max(wave_, reference_); }
  /// Whether steps have become so short that the run would not end.
  bool stuck() const { return stuck_; }
  std::int64_t material_calls() const { return material_calls_; }

 private:
  void look(const mpm::State<Dim>& state, double t);
  double own_speed(const mpm::State<Dim>& state) const;
  double probed_speed(const mpm::State<Dim>& state, double t);
  std::vector<double> state_of(const mpm::State<Dim>& state, std::size_t p) const;

  const ProblemIn<Dim>* problem_;
  Material material_;                ///< an instance of its own
  double wave_ = 0, reference_ = 0;  ///< the latter of a total formulation: across its grid
  double longest_ = 0;               ///< step
  std::int64_t steps_ = 0, material_calls_ = 0;
  bool stuck_ = false;
};

}  // namespace assay::drivers
