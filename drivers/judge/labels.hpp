// SPDX-License-Identifier: BSD-3-Clause
// Mistakes in how a run is written down, told before its forces are looked at: each is a change of the data under which
// the errors fall.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/judge/judgement.hpp"

namespace assay::drivers {

using Change = std::function<void(JudgedRun&)>;
using Causes = std::vector<std::string>;

// Clocks that are fitted.
inline constexpr const char *clock_rate = "clock_rate", *clock_offset = "clock_offset",
                            *velocity_time = "velocity_time";

struct Label {
  std::string cause;                       ///< "clock_offset"
  std::string sentence;                    ///< with what was found, and by how much the error falls
  double before = 0, after = 0;            ///< the error without and with the change
  Change change = {};                      ///< to a run without this mistake
  std::optional<double> lateness = {};     ///< of a fitted clock: its rate less 1, or a time [s]
  std::optional<bool> by_velocities = {};  ///< whether the velocities, too, are those of such a clock
};

/// A body as it was at first [m].
struct BodyPlace {
  Vector3 centre = Vector3::Zero();
  double size = 0;  ///< along the axis where it is largest
};

/// Labels of positions and times, one on top of another, without the causes that are left out. body: the scene's;
/// exact: may be the motion alone.
std::vector<Label> position_labels(const JudgedRun& run, const BodyPlace& body, ExactParticles& exact,
                                   const Causes& left_out = {});

/// Labels of velocities, F and stresses, of a run without those of positions.
std::vector<Label> field_labels(const JudgedRun& run, ExactParticles& exact, const Causes& left_out = {});

/// The run becomes one without them.
void take(const std::vector<Label>& labels, JudgedRun& run);

/// A cause that is left out, and why.
struct DoubtfulClock {
  std::string cause, sentence;
};

/// A method that runs late by itself looks as if its clock were wrong. Of the labels of all runs, and of the spacings
/// of their particles [m], the clocks that cannot be told from that.
std::vector<DoubtfulClock> doubtful_clocks(const std::vector<std::vector<Label>>& labels,
                                           const std::vector<double>& spacing);

}  // namespace assay::drivers
