// SPDX-License-Identifier: BSD-3-Clause
// Particles on a Cartesian lattice, cell by cell, and the grid around them.
#pragma once

#include <functional>

#include "mpm/setup.hpp"

namespace assay::mpm {

/// What becomes of a lattice point: a stepped particle, a held one, or none.
enum class Fate { stepped, held, absent };

/// Lattice points of all cells that meet the box [lower, upper], per_cell in each direction, in cell order.
/// lower, upper [m]; spacing: h [m]. Points outside the box are absent whatever `fate` says.
Seeds<2> cartesian_lattice(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double spacing,
                           const std::array<int, 2>& per_cell,
                           const std::function<Fate(const std::array<double, 2>&)>& fate);

/// Grid with nodes at multiples of h that covers the box and `margin` cells on each side.
GridGeometry<2> grid_around(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double spacing,
                            int margin);

}  // namespace assay::mpm
