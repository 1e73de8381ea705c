// SPDX-License-Identifier: BSD-3-Clause
// The watch over a running simulation: always on, and cheap enough for that. What a single step shows (det F <= 0, no
// number, a particle off the grid) the step itself reports; what shows over several is looked for here.
#pragma once

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

class HealthWatch {
 public:
  HealthWatch(const Problem& problem, const mpm::State<2>& state);

  /// Looks every few steps. steps: taken so far; t: reached [s]; dt: of the last step [s]; wave: the fastest [m/s]. Why
  /// the run must stop, if it must: a velocity or a stress that is no number, or more kinetic energy than the known
  /// forces can have given.
  std::optional<mpm::Finding> look(const mpm::State<2>& state, std::int64_t steps, double t, double dt, double wave);

  /// The worst that was seen.
  const HealthFigures& figures() const { return figures_; }

  /// What did not stop the run and should be known.
  std::vector<std::string> sentences() const;

 private:
  struct Seen {
    double kinetic = 0, fastest = 0, jacobian = 0, extent = 0;
    std::size_t fastest_particle = 0;
    std::optional<std::size_t> no_number;
  };
  Seen scan(const mpm::State<2>& state) const;
  double half_diagonal(const mpm::State<2>& state, std::size_t p) const;
  double acceleration(const mpm::State<2>& state) const;
  double release(const mpm::State<2>& state) const;
  bool judges_energy() const;

  const Problem* problem_;
  bool convects_;         ///< domains of particles
  double mass_ = 0;       ///< of all particles [kg]
  double reachable_ = 0;  ///< root mean square speed that forces can have given so far [m/s]
  double last_t_ = 0, last_acceleration_ = 0;
  HealthFigures figures_;
};

}  // namespace assay::drivers
