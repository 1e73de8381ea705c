// SPDX-License-Identifier: BSD-3-Clause
// The edges of particles' domains that lie on the surface of a body.
#pragma once

#include <array>
#include <vector>

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// Adds the edges of a particle's domain that lie on the faces of the body, a box, unless they are symmetry planes or
/// periodic ends; a domain that fills the box has all four on them.
void add_surface_edges(const Rectangle& body, const std::array<AxisEnds, 2>& ends, const Rectangle& domain,
                       std::uint32_t particle, std::vector<SurfaceEdge>& edges);

/// Adds the arcs of the seeds' domains that lie on the faces of a ring. P N is constant along an arc but for its
/// direction, so that its force is that of P N in the middle on the chord.
void add_face_arcs(const Annulus& ring, Seeds<2>& seeds);

}  // namespace assay::mpm
