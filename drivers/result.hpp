// SPDX-License-Identifier: BSD-3-Clause
// What a verb found: the content of result.json and errors.csv. Figures not reached are absent (null in the file).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace assay {
struct FailedStep;
}

namespace assay::drivers {

using Figure = std::optional<double>;

/// L2 (volume-weighted over the particles that the exact motion moves) and L-infinity of one field at one time.
struct FieldError {
  double l2 = 0, linf = 0;
};

/// One row of errors.csv.
struct ErrorSample {
  double t = 0;                     ///< [s]
  FieldError displacement;          ///< [m]
  double rms36 = 0;                 ///< (36) verbatim, over all particles [m]
  FieldError velocity;              ///< [m/s]
  FieldError deformation_gradient;  ///< Frobenius norm [1]
  FieldError jacobian;              ///< [1]
  FieldError stress;                ///< Cauchy, Frobenius norm [Pa]
};

struct FieldMaximum {
  Figure l2_max, linf_max;
};

struct ErrorFigures {
  Figure l2_half, l2_end, l2_max, linf_max;
  Figure rms36_half, rms36_end, rms36_max;
  FieldMaximum velocity, deformation_gradient, jacobian, stress;
  Figure relative;  ///< l2_max over the largest L2 norm of the exact displacement
};

struct PassFigures {
  std::string name;
  double seconds = 0;
  double bytes_per_particle = 0;  ///< bytes that the pass reads and writes in the particle columns, a particle
};

struct SheetFigures {
  std::int64_t points = 0;
  double error_tau = 0;  ///< relative to the largest component
  Figure error_dtau;     ///< likewise; not known of what is taken along
  Figure error_b;        ///< estimate of the error of the vortex's b at a point, over the largest |b|
  double wall_s = 0;
  bool cached = false;     ///< read from disk
  std::string along = {};  ///< what was taken along the run instead of a sheet: "400 shadow histories"; empty: nothing
  double asked = 0;        ///< force.tolerance
};

/// The stability screen; absent figures: not found.
struct ScreenFigures {
  std::string verdict;            ///< stable, unstable, neutral
  Figure t, xi, gamma;            ///< of the first loss of strong ellipticity [s], [1], [1]
  Figure smallest;                ///< eigenvalue of the acoustic tensor on the path, over the largest at rest [1]
  int unjudged = 0;               ///< places just beyond which the material fails
  Figure largest_safe_amplitude;  ///< in the unit of the motion's peak, where it is not safe as it is
  double wall_s = 0;
};

/// A tabulated response against independent references: relative differences; absent where there is none.
struct ReferenceFigures {
  Figure closed_form;  ///< of the sheet to the material's closed form
  Figure rate_form;    ///< between histories of its rate form by Boost.Odeint and of its increments
};

/// The narrowest zone in which a material with kinks has left its first regime, at the time of the peak.
struct RimFigures {
  double width = 0;  ///< [m]
  double cells = 0;  ///< width / h
};

/// Exponential growth of the displacement's error under tractions.
struct GrowthFigures {
  double rate = 0;          ///< [1/s]
  double from = 0, to = 0;  ///< over which it was seen [s]
};

/// One run of the comparison of traction algorithms.
struct TractionRun {
  std::string algorithm, form;      ///< words of the scene's keys; no form of undeformed_edges, which is neither
  double spacing = 0;               ///< of the grid [m]
  std::array<double, 2> cells{};    ///< across the body
  std::string outcome;              ///< as of a result
  Figure t;                         ///< reached [s]
  Figure l2_end, l2_max;            ///< of the displacement [m]
  bool exact = false, own = false;  ///< uses the exact solution; is of the scene's own algorithm
};

struct TractionTable {
  std::vector<TractionRun> runs;  ///< algorithm by algorithm, from the coarsest grid to the scene's own
  bool of_paper = false;          ///< the problem of the paper's table 1
  double wall_s = 0;
};

struct DriftFigures {
  Figure mass, momentum, angular_momentum, energy;  ///< relative; energy and momenta against the work of the forces
};

/// The worst that the watch over a run saw; absent: not looked for.
struct HealthFigures {
  Figure jacobian_min;   ///< smallest det F [1]
  Figure fastest;        ///< particle [m/s]
  Figure courant;        ///< largest, of the fastest wave on the path and the particles' own speed [1]
  Figure domain_extent;  ///< of convected domains, from a particle to its farther corner [cells]
  Figure energy;         ///< kinetic energy over the most that the known forces can have given [1]
};

struct ExpectationOutcome {
  std::string key;
  std::string expected;  ///< as in the scene: "below 0.07"
  std::string found;     ///< "0.0633", "null"
  bool holds = false;
};

struct Provenance {
  std::string version, git, compiler, flags;
  std::string material;  ///< name and version, and the shared library with its SHA-256, or "built in"
  std::vector<std::string> libraries;
  std::string scene_sha256;
};

struct Result {
  std::string title;
  std::string subject;                            ///< what was run, one line: material, method, grid, amplitude
  std::string outcome = "completed";              ///< completed, unstable, material_failed, refused
  std::string reason;                             ///< one sentence where not completed
  std::string replay;                             ///< file beside the result that shows again what went wrong
  std::string last_good;                          ///< file beside the result with the particles before it did
  std::string advice;                             ///< what an unstable run could try; empty: nothing better is known
  std::shared_ptr<const FailedStep> failed_step;  ///< that step; not in result.json
  std::vector<std::string> warnings;              ///< what did not stop the run and should be known
  bool disturbed = false;                         ///< the process that ran the material: not in result.json
  std::string printed;                            ///< by a material that runs apart; not in result.json
  Figure t, dt;
  std::optional<std::int64_t> steps, particles, moving_particles;
  bool uses_exact_solution = false;  ///< the method is told more than b and the initial state
  ErrorFigures error;
  /// One after the other, of a clock on the wall: until the first step, the steps, and what comes behind them. Together
  /// they are the life of the verb until its verdict; `tabulate` makes its response in place of steps.
  double setup_s = 0, wall_s = 0, finish_s = 0;
  double observed_s = 0;  ///< of wall_s: sampling of the error and snapshots
  double cpu_s = 0;       ///< of the process until then
  Figure step_cpu_s;      ///< processor time of the steps alone: no set-up, no sampling of the error, no snapshots
  std::int64_t peak_rss_bytes = 0;
  std::int64_t particle_steps = 0, material_calls = 0;
  std::int64_t hand_overs = 0, wake_ups = 0;  ///< to workers and back; 0 of a material in this process
  Figure particle_steps_per_s;
  std::vector<PassFigures> passes;
  std::optional<SheetFigures> sheet;
  std::optional<ScreenFigures> screen;
  std::optional<RimFigures> rim;  ///< absent without kinks
  ReferenceFigures reference;
  std::optional<GrowthFigures> growth;     ///< absent where the error does not grow so, or no tractions act
  std::optional<TractionTable> tractions;  ///< only where the scene asks for it
  DriftFigures drift;
  HealthFigures health;
  std::vector<ExpectationOutcome> expect;
  Provenance provenance;
  std::vector<ErrorSample> history;  ///< errors.csv, not in result.json
};

}  // namespace assay::drivers
