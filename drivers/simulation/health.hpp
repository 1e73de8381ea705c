// SPDX-License-Identifier: BSD-3-Clause
// The watch over a running simulation: always on, and cheap enough for that. What a single step shows (det F <= 0, no
// number, a particle off the grid) the step itself reports; what shows over several is looked for here.
#pragma once

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

template <int Dim>
class HealthWatch {
 public:
  HealthWatch(const ProblemIn<Dim>& problem, const mpm::State<Dim>& state);

  /// Looks every few steps. steps: taken so far; t: reached [s]; dt: of the last step [s]; wave: the fastest [m/s]. Why
  /// the run must stop, if it must: a velocity or a stress that is no number, or more kinetic energy than the known
  /// forces can have given.
  std::optional<mpm::Finding> look(const mpm::State<Dim>& state, std::int64_t steps, double t, double dt, double wave);

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
  Seen scan(const mpm::State<Dim>& state) const;
  double half_diagonal(const mpm::State<Dim>& state, std::size_t p) const;
  double acceleration(const mpm::State<Dim>& state) const;
  double release(const mpm::State<Dim>& state) const;
  bool judges_energy() const;

  const ProblemIn<Dim>* problem_;
  bool convects_;         ///< domains of particles
  double mass_ = 0;       ///< of all particles [kg]
  double reachable_ = 0;  ///< root mean square speed that forces can have given so far [m/s]
  double last_t_ = 0, last_acceleration_ = 0;
  HealthFigures figures_;
};

/// Momentum, mass and energy of the particles against what the forces gave them. Drift figures are the largest
/// difference over all checks, relative to the largest amount seen.
template <int Dim>
class Accounts {
 public:
  explicit Accounts(const mpm::State<Dim>& state);

  void check(const mpm::State<Dim>& state);
  DriftFigures drift() const;

 private:
  struct Amounts {
    std::array<double, Dim> momentum{};        ///< [N s]
    double momentum_scale = 0;                 ///< sum of m |v| [N s]
    std::array<double, 3> angular_momentum{};  ///< about the origin; in the plane about E_z [N m s]
    double angular_scale = 0;                  ///< sum of its parts' sizes [N m s]
    double kinetic_energy = 0;                 ///< [J]
  };
  static Amounts amounts_of(const mpm::State<Dim>& state);

  Amounts first_;
  bool held_ = false;  ///< reactions act: the angular account does not close
  double momentum_ = 0, momentum_scale_ = 0, angular_ = 0, angular_scale_ = 0, energy_ = 0, energy_scale_ = 0;
  double mass_ = 0;
};

// Whether an error that should be rounding grows exponentially: the mark of an unstable form of a traction.

/// The longest stretch of the history over which ln(L2 error of u) is a straight line in time and the error grows by a
/// factor of 1000 or more; absent where there is none.
std::optional<GrowthFigures> growth_of(const std::vector<ErrorSample>& history);

/// What to do about it, for a motion under tractions.
std::string growth_sentence(const GrowthFigures& growth, mpm::TractionForm form, const Units& units);

}  // namespace assay::drivers
