// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs a scene has to be told of, before it runs and after.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/exact/response.hpp"

namespace assay {
struct Vortex;
}

namespace assay::drivers {

/// Of a table of F whose spline goes beyond two neighbouring rows: where it does so the farthest. Empty: nowhere.
std::string swing_sentence(const Scene& scene);

/// For a ring's motion that is very long against the waves in the body: a period that they cross it some thirty times
/// in [s].
template <int Dim>
std::optional<double> shorter_period(const ProblemIn<Dim>& problem);

/// The period [s] in which the fastest wave crosses the body twice, of a vortex that has several times as many
/// crossings; nothing for others.
template <int Dim>
std::optional<double> period_of_few_waves(const ProblemIn<Dim>& problem);

/// A period [s] for motion.period; where the scene says when it ends, with the time.end that goes with it.
std::string period_text(const PosedScene& problem, double period);

/// That it is, which is to be told before a run of hours; empty: it is not.
template <int Dim>
std::string long_motion_sentence(const ProblemIn<Dim>& problem);

/// One sentence each: a motion that is very long against the waves in the body; fixed steps beyond a Courant number of
/// 1; stress at rest, which free faces do not bear; a spline that goes beyond its rows; a body force that jumps at rows
/// by more than steps of this length resolve; snapshots from a time on that is not reached; a density in t/mm^3; cells
/// larger than the body; particles at the ends of splines; a vortex in space that is few cells thick.
template <int Dim>
std::vector<std::string> warnings_of(const ProblemIn<Dim>& problem);

// After the run.

/// Adds a sentence where the exact motion has not moved the body whenever the error was sampled.
void warn_of_stillness(const PosedScene& problem, double largest_displacement, Result& result);

/// What lives through more of the hard cases (docs/hard.md, bench/results/hard) than the method of this run; empty
/// where nothing does. reason: of which it died.
template <int Dim>
std::string advice_after_death(const ProblemIn<Dim>& problem, const std::string& reason = {});

/// What makes the errors smaller of a run that has completed with errors larger than its motion; empty for others.
/// `relative`: the largest error over the largest displacement.
template <int Dim>
std::string advice_after_large_error(const ProblemIn<Dim>& problem, double relative);

/// Lengths of the body along the axes [m]; zeros without particles.
template <int Dim>
std::array<double, Dim> sides_of_body(const ProblemIn<Dim>& problem);

// The stability screen of a scene's motion: its figures, and what a verb says of them.

/// Over 0 .. end [s], at most four periods. A terminal sees how far it is, unless `quiet`. Throws MaterialFailure.
ScreenFigures screen_of(const Scene& scene, const Material& material, double end, bool quiet);

/// Why the motion is no stable solution, one sentence; empty where it is one.
std::string instability_sentence(const ScreenFigures& screen, const std::string& material, const Units& units);

/// The same where the scene does not allow it: why a run is refused.
std::string refusal_sentence(const Scene& scene, const ScreenFigures& screen, const std::string& material);

/// "stable, ...", for explain and for people, one line without its end.
std::string screen_sentence(const ScreenFigures& screen, const Units& units);

/// One line on standard error where the motion is unstable and the scene does not allow that. Never stops a verb: a
/// material that fails on the way is found by what follows. Throws Interrupted when a signal came.
void warn_of_instability(const Scene& scene, const Material& material, double end, bool quiet);

// The plastic rim of a vortex: how many grid cells the narrowest zone has in which a material with kinks has left its
// first regime.

constexpr double fewest_rim_cells = 2;

/// Rings of the vortex in which xi(R) lies beyond the fronts next to xi = 0: [r, R] [m], ascending. Fronts further out
/// do not cut them: a sheet has one wherever histories of other times part. fronts: values of xi other than 0.
std::vector<Interval> zones_beyond(const Vortex& vortex, std::span<const double> fronts);

/// The narrowest zone at the time of the largest |g| in 0 .. end, for a grid of spacing h [m]. Absent without a sheet,
/// without kinks, and where no zone has left the first regime.
std::optional<RimFigures> rim_of(const Response& response, const Vortex& vortex, double h, double end);

/// "the plastic rim is .. wide, .. cells: .."; empty where it has fewest_rim_cells or more.
std::string narrow_rim_sentence(const RimFigures& rim, const Units& units);

/// What is wrong with a body without particles: far from the origin the numbers themselves may lie further apart than
/// particles can bear.
std::string no_particle_sentence(const PosedScene& problem);

}  // namespace assay::drivers
