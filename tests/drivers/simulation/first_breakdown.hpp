// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

/// When a scene's particles first break down, by a loop that has no watch and looks at all of them after each step.
struct Breakdown {
  double t = 0;      ///< end of that step, infinity where there is none [s]
  double run = 0;    ///< time.end [s]
  std::string what;  ///< the first of: det F, value, grid, material
};

/// Of a scene file. det F <= 0, a velocity or det F that is no number, a particle within half a cell of the grid's
/// edge, or a material that fails; throws as the reader and the composition do.
Breakdown first_breakdown(const std::string& scene, const std::vector<std::string>& sets);

}  // namespace assay::drivers
