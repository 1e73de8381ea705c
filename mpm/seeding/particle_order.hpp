// SPDX-License-Identifier: BSD-3-Clause
// In which order particles stand: those of the same nodes together, so that they are worked on together.
#pragma once

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// By the nodes that the particles of a setup reach in the reference configuration; among particles of the same nodes
/// as before. Particles with domains of their own, and those of bases that reach different numbers of nodes, stay in
/// cell order.
void order_by_nodes(Setup<2>& setup);

}  // namespace assay::mpm
