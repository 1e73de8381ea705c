// SPDX-License-Identifier: BSD-3-Clause
// The body that is exported, and its ladder of grids.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/export/export.hpp"

namespace assay::drivers {

/// A box along the axes. A vortex lies in a box whose rest stands still; a ring that widens is one.
struct ExportedBody {
  std::array<double, 3> lower{}, upper{};  ///< in the plane Z = 0 [m]
  bool may_grow = false;                   ///< the box may be larger: what is added stands still
  std::optional<Annulus> ring = {};        ///< in place of the box
};

/// Throws InputError where the body is none that can be filled with cells.
ExportedBody exported_body(const Scene& scene, int dimension);

/// The spacings that --grids gives, else three of the scene's own, the coarsest first [m]. Throws InputError.
std::vector<double> spacings_of_ladder(const std::string& given, const Scene& scene, const ExportedBody& body,
                                       int dimension);

/// A grid with its seeds, without velocities. Throws InputError where h does not divide the body.
ExportedGrid grid_of(double h, const ExportedBody& body, int dimension, double density, SeedPlace place);

/// The same of a ring.
ExportedGrid ring_grid_of(double h, const Annulus& ring, double density, SeedPlace place);

}  // namespace assay::drivers
