// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// Nodes of the tiles (mpm/grid/live_nodes.hpp) that are live in the first step: those that blocks of particles reach,
/// those of particles that never move, and images. Found before anything of a run is allocated.
std::size_t nodes_reached(const Setup<2>& setup);

/// By the nodes that the particles of a setup reach in the reference configuration; among particles of the same nodes
/// as before. Particles with domains of their own, and those of bases that reach different numbers of nodes, stay in
/// cell order.
void order_by_nodes(Setup<2>& setup);

}  // namespace assay::mpm
