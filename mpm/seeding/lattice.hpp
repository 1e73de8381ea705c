// SPDX-License-Identifier: BSD-3-Clause
// Particles on lattices, and the grid around them.
#pragma once

#include <functional>
#include <type_traits>

#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// What becomes of a lattice point: a stepped particle, a held one, or none.
enum class Fate { stepped, held, absent };

/// Between two corners, along the axes [m]: in the plane a Rectangle.
struct Cuboid {
  std::array<double, 3> lower{}, upper{};
};
template <std::size_t N>
using BoxOfAxes = std::conditional_t<N == 2, Rectangle, Cuboid>;

template <std::size_t N>
using FateOf = std::function<Fate(const std::array<double, N>&)>;

/// Lattice points of all cells that meet the box [lower, upper], per_cell in each direction, in cell order.
/// lower, upper [m]; spacing: h [m]. Points outside the box are absent whatever `fate` says.
template <std::size_t N>
Seeds<int{N}> cartesian_lattice(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                const std::array<int, N>& per_cell, const std::type_identity_t<FateOf<N>>& fate);

/// The same with points anywhere in their cells: the coordinate along axis d of point k of a cell [m].
using CellPoint = std::function<double(std::size_t d, std::int32_t cell, int k)>;
template <std::size_t N>
Seeds<int{N}> lattice_of(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                         const std::array<int, N>& per_cell, const CellPoint& coordinate,
                         const std::type_identity_t<FateOf<N>>& fate);

/// Moves every particle, held ones too, along each axis by less than `fraction` of the distance between particles, to
/// either side: as a hash of seed, particle and axis says, which is the same on all machines. Volumes and domains stay.
/// A stepped particle that would no longer be inside the body stays where it is.
template <int Dim>
void disturb(Seeds<Dim>& seeds, double fraction, std::uint64_t seed,
             const std::type_identity_t<std::function<bool(const std::array<double, Dim>&)>>& inside = {});

/// The part of each cell of a Cartesian lattice inside the ring is a particle, at the part's centroid and with its
/// volume. For the basis its domain is a whole cell around the centroid: as good as the part's box or the rectangle of
/// its second moments (errors within 3 %, measured), and no sliver's domain is small, so that no node's force can be
/// large for its mass.
Seeds<2> clipped_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell);

/// Rings of sectors, ring by ring from the inside, each particle at its sector's centroid. Rings are as wide as h /
/// per_cell[0] or a little less; each holds a multiple of four sectors, as long in the middle as h / per_cell[1] or a
/// little less. share_corners: all rings hold as many sectors as one in the middle would, and the domains for the basis
/// have the sectors' corners, which neighbours share.
Seeds<2> polar_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell,
                       bool share_corners = false);

/// Rectangles half_size around the particles; neighbours share corners to the last bit where they stand on a lattice.
ReferenceDomains rectangles_of(const Seeds<2>& seeds, const Annulus& ring);

/// Turns the body about the origin: its particles, and the domains that the body force is averaged over where there
/// are any. With half_edges the basis is given turned domains; without, its boxes stay along the axes and keep their
/// volume.
void turn(Seeds<2>& seeds, double angle, bool half_edges);

/// Turns a body in space by R: its particles, half edges, averaged domains and surface. The basis is given turned
/// domains where it takes them (half_edges); its boxes stay along the axes otherwise, and keep their volume.
void turn(Seeds<3>& seeds, const Tensor& R, bool half_edges);

/// Grid with nodes at multiples of h that covers the box and `margin` cells on each side.
template <std::size_t N>
GridGeometry<int{N}> grid_around(const std::array<double, N>& lower, const std::array<double, N>& upper, double spacing,
                                 int margin);

// The edges of particles' domains that lie on the surface of a body.

/// Adds the edges, or in space the faces, of a particle's domain that lie on the faces of the body, a box, unless they
/// are symmetry planes or periodic ends; a domain that fills the box has all of them.
template <std::size_t N>
void add_surface_edges(const BoxOfAxes<N>& body, const std::array<AxisEnds, N>& ends, const BoxOfAxes<N>& domain,
                       std::uint32_t particle, std::vector<SurfacePiece<int{N}>>& pieces);

/// Adds the arcs of the seeds' domains that lie on the faces of a ring. P N is constant along an arc but for its
/// direction, so that its force is that of P N in the middle on the chord.
void add_face_arcs(const Annulus& ring, Seeds<2>& seeds);

// Seeds on the grid of a setup.

/// Nodes of the tiles (mpm/grid/live_nodes.hpp) that are live in the first step: those that blocks of particles reach,
/// those of particles that never move, and images. Found before anything of a run is allocated.
template <int Dim>
std::size_t nodes_reached(const Setup<Dim>& setup);

/// By the nodes that the particles of a setup reach in the reference configuration; among particles of the same nodes
/// as before. Particles with domains of their own, and those of bases that reach different numbers of nodes, stay in
/// cell order.
template <int Dim>
void order_by_nodes(Setup<Dim>& setup);

}  // namespace assay::mpm
