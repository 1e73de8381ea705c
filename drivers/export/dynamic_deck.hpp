// SPDX-License-Identifier: BSD-3-Clause
// Decks with inertia: nodal forces whose histories are amplitudes, straight between their times.
#pragma once

#include <string>

#include "drivers/export/export.hpp"

namespace assay::drivers {

struct DynamicLoads {
  ExportedGrid solid;      ///< the grid; in the plane a layer of it, one metre thick, whose lower nodes come first
  std::string amplitudes;  ///< *AMPLITUDE of each loaded node of the grid and direction; *INITIAL CONDITIONS
  std::string loads;       ///< *CLOAD of each, for the step
  double error = 0;        ///< of the straight lines, of the largest force [1]
  std::size_t times = 0;
};

DynamicLoads dynamic_loads(const ExportedProblem& problem, const ExportedGrid& grid);

/// Whether a node bears a load: one beyond rounding, of the largest force of all.
std::vector<char> loaded_nodes(const std::vector<std::vector<Vector3>>& forces, std::size_t nodes);

}  // namespace assay::drivers
