// SPDX-License-Identifier: BSD-3-Clause
// The files that every target has in common.
#pragma once

#include <string>

#include "drivers/export/export.hpp"

namespace assay::drivers {

inline constexpr std::size_t page_width = 120;  ///< columns of README.md

/// seeds.csv: id, X, Y, volume, mass, vx, vy; in space Z and vz, too.
std::string seeds_csv(const ExportedGrid& grid, int dimension);

/// README.md: what the target says, the problem, and how to judge.
std::string readme_of(const ExportedProblem& problem, const Target& target, const Deck& deck);

/// judge.map.yaml: what the target says, and the hash of the scene.
std::string map_of(const ExportedProblem& problem, const Deck& deck);

}  // namespace assay::drivers
