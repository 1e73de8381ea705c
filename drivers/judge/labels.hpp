// SPDX-License-Identifier: BSD-3-Clause
// Mistakes in how a run is written down, told before its forces are looked at: each is a change of the data under which
// the errors fall.
#pragma once

#include <string>
#include <vector>

#include "drivers/judge/judgement.hpp"

namespace assay::drivers {

struct Label {
  std::string cause;             ///< "clock_offset"
  std::string sentence;          ///< with what was found, and by how much the error falls
  double before = 0, after = 0;  ///< the error without and with the change
};

/// Labels of positions and times. The run becomes one without them. body: the centre of the scene's body [m]; exact:
/// may be the motion alone.
std::vector<Label> take_position_labels(JudgedRun& run, const Vector3& body, ExactParticles& exact);

/// Labels of velocities, F and stresses, behind those of positions. The run becomes one without them.
void take_field_labels(JudgedRun& run, ExactParticles& exact, std::vector<Label>& labels);

}  // namespace assay::drivers
