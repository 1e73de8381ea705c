// SPDX-License-Identifier: BSD-3-Clause
// Nodes that particles reach by their slopes alone. A particle on a line between cells has no weight at the nodes
// across, or one of rounding, but a slope of 1/h: its velocity gradient takes the velocity of nodes that have no mass
// to have one, and its stress gives them forces that nothing takes up.
#pragma once

#include "mpm/step/passes_grid.hpp"

namespace assay::mpm {

/// Whether particles can lie where their weights vanish and slopes do not: with the linear basis anywhere; with
/// B-splines on the grid's edge, where the node there alone has a weight, and only a body that begins there does. Those
/// of the other bases vanish together.
template <int Dim>
bool has_massless_nodes(const Setup<Dim>& setup);

/// Mass, momentum and force of nodes of less than 1e-11 rho0 h^Dim go to the nearest neighbours that have more, by
/// their masses: along the axes; where none has, across the diagonals. Nodes that are held keep theirs. What is handed
/// over in a step is kept in sum.
template <int Dim>
Pass<Dim> fold_massless_pass(Phase phase, Folded what);

/// Those nodes move as these neighbours do, by their masses.
template <int Dim>
Pass<Dim> unfold_massless_pass(Phase phase);

}  // namespace assay::mpm
