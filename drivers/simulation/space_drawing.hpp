// SPDX-License-Identifier: BSD-3-Clause
// Bodies in space as pictures show them: a cut through the body, and a view of it with a quarter taken out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/picture/value_pictures.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

/// Polygons, and of which particle each is.
struct SpaceShapes {
  ParticleFrame frame;
  std::vector<std::uint32_t> particles;
};

class SpaceDrawing {
 public:
  explicit SpaceDrawing(const ProblemIn<3>& problem);

  /// Where the domains meet the plane through the middle, across the axis of the vortex or across z.
  SpaceShapes cut(const mpm::State<3>& state, double t) const;
  /// The surface, seen from aside; the quarter that would hide the inside is left out.
  SpaceShapes view(const mpm::State<3>& state, double t) const;

  /// Of the axes of the cut.
  std::array<std::string, 2> labels() const;
  double reach() const { return reach_; }  ///< of the body on all of its way from the middle of a picture [m]

 private:
  using Corners = std::array<Vector3, 8>;  ///< in the order of mpm::Corners
  Corners corners_of(const mpm::State<3>& state, std::size_t p, double t) const;
  Vector3 reference_of(std::size_t p) const;

  const ProblemIn<3>* problem_;
  Vector3 middle_;  ///< of the pictures [m]
  Tensor axes_;     ///< rows: the two of the cut, and its normal
  bool by_axis_;    ///< the normal is the axis of a vortex
  double reach_ = 0;
  std::vector<std::uint8_t> open_;   ///< faces of a particle without a neighbour: bit 2 d + side
  std::vector<std::uint8_t> inner_;  ///< those on the quarter that is left out; of a particle in it all
};

}  // namespace assay::drivers
