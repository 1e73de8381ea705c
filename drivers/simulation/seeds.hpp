// SPDX-License-Identifier: BSD-3-Clause
// The particles that a scene's body and lattice call for.
#pragma once

#include "drivers/scene/scene.hpp"
#include "mpm/setup/setup.hpp"

namespace assay::drivers {

/// Of a scene of the vortex with a grid. On a square or box whose outside is held, a particle is stepped where its
/// centre lies in the ring; with an averaged force, also where only a part of its cell does: it bears a share of it.
/// A frame's angle turns them all; uGIMP's boxes stay along the axes.
mpm::Seeds<2> seeds_of(const Scene& scene);

}  // namespace assay::drivers
