// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/seeding/surface_edges.hpp"

#include <cmath>

namespace assay::mpm {

namespace {

/// An edge this close to a face [relative to the body] lies on it.
constexpr double face_rounding = 1e-12;

}  // namespace

void add_surface_edges(const Rectangle& body, const std::array<AxisEnds, 2>& ends, const Rectangle& domain,
                       std::uint32_t particle, std::vector<SurfaceEdge>& edges) {
  const auto corner = [&](std::size_t c) {
    return Point{(c & 1) ? domain.upper[0] : domain.lower[0], (c & 2) ? domain.upper[1] : domain.lower[1]};
  };
  const double near = face_rounding * (body.upper[0] - body.lower[0] + body.upper[1] - body.lower[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t along = 1 - d;
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? body.upper[d] : body.lower[d];
      if (std::abs(at - face) > near || (upper ? ends[d].upper : ends[d].lower)) continue;
      const auto first = static_cast<std::uint8_t>(upper ? 1u << d : 0u);
      const auto second = static_cast<std::uint8_t>(first | 1u << along);
      const Point a = corner(first), b = corner(second);
      SurfaceEdge edge{particle, {first, second}, {}, {a, b}, {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}};
      edge.N_dA[d] = (upper ? 1 : -1) * (domain.upper[along] - domain.lower[along]);
      edges.push_back(edge);
    }
  }
}

void add_face_arcs(const Annulus& ring, Seeds<2>& seeds) {
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const ReferenceDomains::Place& place = seeds.domains->places[p];
    for (const BoundaryPiece& piece : seeds.domains->shapes[place.shape].boundary) {
      const bool outer = piece.sweep > 0;
      if (piece.straight() || piece.radius != (outer ? ring.outer : ring.inner)) continue;
      const double middle = piece.from + 0.5 * piece.sweep, chord = 2 * piece.radius * std::sin(0.5 * piece.sweep);
      const Point out = place.turned({std::cos(middle), std::sin(middle)});
      SurfaceEdge edge{static_cast<std::uint32_t>(p), {}, {chord * out[0], chord * out[1]}, {}, {}};
      edge.X = {place.turned(piece.a), place.turned(piece.b)};
      edge.middle = {piece.radius * out[0], piece.radius * out[1]};
      if (!outer) std::swap(edge.X[0], edge.X[1]);  // counterclockwise
      edge.on_corners = !seeds.corners.empty();     // in the order in which polar_lattice gives them
      edge.corners = outer ? std::array<std::uint8_t, 2>{1, 3} : std::array<std::uint8_t, 2>{0, 2};
      seeds.surface.push_back(edge);
    }
  }
}

}  // namespace assay::mpm
