// SPDX-License-Identifier: BSD-3-Clause
// The pieces of a body force in the expression languages of particle codes.
#pragma once

#include <array>
#include <string>

#include "drivers/export/force_pieces.hpp"
#include "drivers/export/force_sources.hpp"

namespace assay::drivers {

/// Lines of an input of LAMMPS with atom-style variables: b_x, b_y [m/s^2], and v_x, v_y, the velocities at t = 0
/// [m/s]. current: b at the current positions. Else at the reference positions, which the fix `ref` of the style
/// store/state holds; the velocities are of the positions at t = 0 in both cases.
std::string lammps_force(const ForcePieces& pieces, ForceCoordinates at);

/// Lines of an input of Karamelo with the variables bx, by [m/s^2] and vx0, vy0 [m/s] of the position (x0, y0). They
/// hold in the ring alone.
/// A node's x0 is its reference position where the formulation is total, else its current one.
std::string karamelo_force(const ForcePieces& pieces, ForceCoordinates at);

/// Functions of x, y and t for NairnMPM in units of m, kg and s: b at the current position [m/s^2], and the velocity at
/// t = 0 [m/s].
struct NairnFunctions {
  std::array<std::string, 2> b, v;
};
NairnFunctions nairn_force(const ForcePieces& pieces);

}  // namespace assay::drivers
