// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs a scene has to be told of before it runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// Of a table of F whose spline goes beyond two neighbouring rows: where it does so the farthest. Empty: nowhere.
std::string swing_sentence(const Scene& scene);

/// For a ring's motion that is very long against the waves in the body: a period that they cross it some thirty times
/// in [s].
std::optional<double> shorter_period(const Problem& problem);

/// The period [s] in which the fastest wave crosses the body twice, of a vortex that has several times as many
/// crossings; nothing for others.
std::optional<double> period_of_few_waves(const Problem& problem);

/// A period [s] for motion.period; where the scene says when it ends, with the time.end that goes with it.
std::string period_text(const Problem& problem, double period);

/// That it is, which is to be told before a run of hours; empty: it is not.
std::string long_motion_sentence(const Problem& problem);

/// One sentence each: a motion that is very long against the waves in the body; a time.step beyond a Courant number of
/// 1; stress at rest, which free faces do not bear; a spline that goes beyond its rows; a body force that jumps at rows
/// by more than steps of this length resolve; snapshots from a time on that is not reached; a density in t/mm^3; cells
/// larger than the body; particles at the ends of splines.
std::vector<std::string> warnings_of(const Problem& problem);

}  // namespace assay::drivers
