// SPDX-License-Identifier: BSD-3-Clause
// Bodies in space as pictures show them: a cut through the body, and a view of it with a quarter taken out.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/picture/value_pictures.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/space_domains.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

/// Polygons, and of which particle each is.
struct SpaceShapes {
  ParticleFrame frame;
  std::vector<std::uint32_t> particles;
};

/// Pictures stand still in the body's own frame: they follow its flight and its spin.
class SpaceDrawing {
 public:
  explicit SpaceDrawing(const ProblemIn<3>& problem);

  /// Where the domains meet the plane through the middle, across the axis of the vortex or across z.
  SpaceShapes cut(const mpm::State<3>& state, double t) const;
  /// The surface, seen from aside; the quarter that would hide the inside is left out. Faces between particles that
  /// have come apart are surface too.
  SpaceShapes view(const mpm::State<3>& state, double t) const;

  /// Of the axes of the cut.
  std::array<std::string, 2> labels() const;
  /// Where the cut is: "across the axis of the vortex".
  std::string cut_words() const;
  /// x, y and z as the view shows them.
  std::vector<SpaceAxis> axes_of_view() const;
  /// Where the exact motion takes the body, in the coordinates of the cut or of the view [m].
  Box reach_of_cut() const { return reach(axes_); }
  Box reach_of_view() const;

 private:
  /// The six faces of a domain, and the particles beside it.
  struct Neighbours {
    std::array<std::uint32_t, 3> above;  ///< along each axis of the lattice; no_particle: none
    std::array<bool, 3> has_below;
    bool left_out;  ///< with the quarter
  };
  struct Face;
  Box reach(const Tensor& axes) const;
  std::vector<Face> faces_of(const mpm::State<3>& state, double t) const;

  const ProblemIn<3>* problem_;
  SpaceDomains domains_;
  Vector3 middle_;             ///< of the pictures [m]
  Tensor axes_;                ///< rows: the two of the cut, and its normal
  bool by_axis_;               ///< the normal is the axis of a vortex
  std::vector<Vector3> ends_;  ///< of the box around all of the body's way [m]
  std::vector<Neighbours> neighbours_;
};

}  // namespace assay::drivers
