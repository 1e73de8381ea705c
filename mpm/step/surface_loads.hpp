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

/// A point at which a share of an edge's force acts.
struct SurfacePoint {
  std::uint32_t particle = 0;
  int corner = -1;                    ///< of the particle's domain; -1: none
  Vec<2> offset{};                    ///< from the particle in the reference configuration [m]
  double share = 1;                   ///< of the edge's force
  Vec<2> force{};                     ///< now [N]
  const SurfaceEdge* edge = nullptr;  ///< to which it belongs
};

/// The grid's functions at the points: multilinear ones, or B-splines; or phi_ip of the particles.
struct SurfaceLoads {
  std::vector<SurfacePoint> points;
  std::function<bool(std::size_t, const Vec<2>&)> place;  ///< of a point; false outside the grid
  std::function<NodeBox<2>(std::size_t)> reach;           ///< nodes of a point that those of particles may not hold
  std::function<void(std::size_t, double*)> scatter;      ///< its force to the field of forces
  std::function<Vec<2>(std::size_t, const double*)> velocity;  ///< at it, from the field of motion
};

/// Makes those that the state owns.
void place_loads(State<2>& s, std::vector<SurfacePoint> points, bool at_particles);

}  // namespace assay::mpm
