// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a grid as text.
#pragma once

#include <string>

#include "drivers/export/export.hpp"

namespace assay::drivers {

/// id, n1, n2, ...: the nodes of each element, counterclockwise; of a hexahedron the lower four first.
std::string elements_csv(const ExportedGrid& grid, int dimension);

/// id of the nodes on the surface of the body.
std::string surface_csv(const ExportedGrid& grid, int dimension);

/// A number that has at most 20 characters, which is what readers of .inp files take.
std::string deck_number(double value);

/// *NODE and *ELEMENT of an .inp file, with the sets ALL and EDGE of nodes and BODY of elements. EDGE is the surface
/// across the first `across` axes.
std::string mesh_of_deck(const ExportedGrid& grid, int dimension, const std::string& element, int across);

}  // namespace assay::drivers
