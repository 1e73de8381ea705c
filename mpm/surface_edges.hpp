// SPDX-License-Identifier: BSD-3-Clause
// The edges of particles' domains that lie on the surface of a body.
#pragma once

#include <vector>

#include "harness/reference_domain.hpp"
#include "mpm/traction.hpp"

namespace assay::mpm {

/// Adds the edges of a particle's domain that lie on the faces of the body, a box; a domain that fills the box has all
/// four on them.
void add_surface_edges(const Rectangle& body, const Rectangle& domain, std::uint32_t particle,
                       std::vector<SurfaceEdge>& edges);

}  // namespace assay::mpm
