// SPDX-License-Identifier: BSD-3-Clause
// Steps as long as the particles allow now, in place of equal ones planned by the exact motion.
#pragma once

#include <algorithm>

#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

class TimeControl {
 public:
  TimeControl(const Problem& problem, const mpm::State<2>& state);

  /// End of the step that begins at t [s]: by the Courant number of the fastest wave and particle, which are looked
  /// for every few steps; T/2, its multiples and the end of the run are met.
  double next(const mpm::State<2>& state, double t);

  /// The fastest wave across the grid, when it was last looked for [m/s].
  double wave_speed() const { return std::max(wave_, reference_); }
  /// Whether steps have become so short that the run would not end.
  bool stuck() const { return stuck_; }
  std::int64_t material_calls() const { return material_calls_; }

 private:
  void look(const mpm::State<2>& state, double t);
  double own_speed(const mpm::State<2>& state) const;
  double probed_speed(const mpm::State<2>& state, double t);
  std::vector<double> state_of(const mpm::State<2>& state, std::size_t p) const;

  const Problem* problem_;
  Material material_;                ///< an instance of its own
  double wave_ = 0, reference_ = 0;  ///< the latter of a total formulation: across its grid
  double longest_ = 0;               ///< step
  std::int64_t steps_ = 0, material_calls_ = 0;
  bool stuck_ = false;
};

}  // namespace assay::drivers
