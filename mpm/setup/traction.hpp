// SPDX-License-Identifier: BSD-3-Clause
// Prescribed tractions on the body's surface.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace assay::mpm {

/// How a traction reaches the grid.
enum class TractionAlgorithm {
  edges,             ///< by the corners of the particles' domains that lie on the surface, or the middle between them
  virtual_stress,    ///< as the forces that the exact stress, continued beyond the surface, would leave out
  particles,         ///< at the centres of the particles of the surface
  undeformed_edges,  ///< as edges, the traction per current area times the undeformed length
};
constexpr std::array<const char*, 4> names_of(TractionAlgorithm) {
  return {"edges", "virtual_stress", "particles", "undeformed_edges"};
}

/// Of which two forces that agree on the exact state: sigma n ds, which follows the surface, or P N dA0, which does
/// not.
enum class TractionForm { follower, reference };
constexpr std::array<const char*, 2> names_of(TractionForm) { return {"follower", "reference"}; }

struct Traction {
  TractionAlgorithm algorithm = TractionAlgorithm::edges;
  TractionForm form = TractionForm::reference;
};

/// A piece of the body's surface, an edge of a particle's domain or an arc at its end.
struct SurfaceEdge {
  std::uint32_t particle = 0;
  std::array<std::uint8_t, 2> corners{};  ///< of the domain, in the order of `Corners`
  std::array<double, 2>
      N_dA{};  ///< outward normal of the reference configuration times the length of the line between its ends [m]
  std::array<std::array<double, 2>, 2> X{};  ///< where those corners are in it [m]
  std::array<double, 2> middle{};            ///< the point of the surface of which the traction is taken [m]
  bool on_corners = true;                    ///< whether its ends are those
};

}  // namespace assay::mpm
