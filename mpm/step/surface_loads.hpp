// SPDX-License-Identifier: BSD-3-Clause
// Point forces on the surface, and the functions of the grid by which they act.
#pragma once

#include <functional>
#include <vector>

#include "mpm/basis/basis.hpp"
#include "mpm/setup/setup.hpp"

namespace assay::mpm {

template <int Dim>
struct State;

/// A point at which a share of a piece's force acts.
template <int Dim>
struct SurfacePoint {
  std::uint32_t particle = 0;
  int corner = -1;                           ///< of the particle's domain; -1: none
  Vec<Dim> offset{};                         ///< from the particle in the reference configuration [m]
  int end = -1;                              ///< of the piece, whose share of the force it bears; -1: all
  Vec<Dim> force{};                          ///< now [N]
  const SurfacePiece<Dim>* piece = nullptr;  ///< to which it belongs
};

/// The grid's functions at the points: multilinear ones, or B-splines; or phi_ip of the particles.
template <int Dim>
struct SurfaceLoads {
  std::vector<SurfacePoint<Dim>> points;
  std::function<bool(std::size_t, const Vec<Dim>&)> place;  ///< of a point; false outside the grid
  std::function<NodeBox<Dim>(std::size_t)> reach;           ///< nodes of a point that those of particles may not hold
  std::function<void(std::size_t, double*)> scatter;        ///< its force to the field of forces
  std::function<Vec<Dim>(std::size_t, const double*)> velocity;  ///< at it, from the field of motion
};

/// Makes those that the state owns.
template <int Dim>
void place_loads(State<Dim>& s, std::vector<SurfacePoint<Dim>> points, bool at_particles);

}  // namespace assay::mpm
