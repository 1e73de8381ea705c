// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// Nodes of the tiles (mpm/grid/live_nodes.hpp) that are live in the first step: those that blocks of particles reach,
/// those of particles that never move, and images. Found before anything of a run is allocated.
std::size_t nodes_reached(const Setup<2>& setup);

}  // namespace assay::mpm
