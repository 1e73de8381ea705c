// SPDX-License-Identifier: BSD-3-Clause
// Changes of a run under which its errors may fall: what labels are made of.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/judge/judgement.hpp"
#include "drivers/judge/labels.hpp"

namespace assay::drivers {

struct Candidate {
  std::string cause, sentence;
  Change change;
  bool needs_all = false;               ///< particles: it looks for the nearest one
  std::optional<double> lateness = {};  ///< of a fitted clock: its rate less 1, or a time [s]
};

/// A run, how its particles are told, and how far they are off.
struct JudgedState {
  JudgedRun run;
  Seeds seeds;
  Pairing pairing;
  PositionError error;
};

/// So many times smaller the error must become for a label.
inline constexpr double telling = 3;
inline constexpr double rounding = 1e-9;  ///< an error of this share of the displacement says nothing

/// Where the body is far larger or smaller than that of the scene; else empty.
std::string size_words(const Seeds& seeds, const BodyPlace& body);

/// The unit in which the body is about as large as that of the scene, where it is not without one. It tells where no
/// error does: of a body that lies beyond all that moves, or is stretched evenly.
std::optional<Candidate> unit_by_size(const Seeds& seeds, const BodyPlace& body);

/// Of positions, without the causes that are left out. now: of some particles; seeds: of all. body: the scene's.
/// interval: between frames of the whole run [s].
std::vector<Candidate> position_changes(const JudgedState& now, const Seeds& seeds, const BodyPlace& body,
                                        double interval, ExactParticles& exact, const Causes& left_out);

/// Some frames evenly over the time, the first one, from which the seeds may come, among them; of some particles, the
/// same ones in all frames, where that can be told.
JudgedRun thin_of(const JudgedRun& run);

/// Whether no frame lies between a fifth and four fifths of the period, of which `half` is the half [s].
bool only_at_rest(const JudgedRun& run, double half);

/// Mean time between frames [s]; 0 of a single one.
double interval_of(const JudgedRun& run);

/// Where a function is least: of evenly spaced places the best one, refined between its neighbours.
double least_place(double lower, double upper, const std::function<double(double)>& f);

/// "; the error falls from 1 to 0.1 m"; empty where there was none before.
std::string by_how_much(double before, double after, const std::string& unit);

}  // namespace assay::drivers
