// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/surface_edges.hpp"

#include <cmath>

namespace assay::mpm {

namespace {

/// An edge this close to a face [relative to the body] lies on it.
constexpr double face_rounding = 1e-12;

}  // namespace

void add_surface_edges(const Rectangle& body, const Rectangle& domain, std::uint32_t particle,
                       std::vector<SurfaceEdge>& edges) {
  const auto corner = [&](std::size_t c) {
    return Point{(c & 1) ? domain.upper[0] : domain.lower[0], (c & 2) ? domain.upper[1] : domain.lower[1]};
  };
  const double near = face_rounding * (body.upper[0] - body.lower[0] + body.upper[1] - body.lower[1]);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t along = 1 - d;
    for (const bool upper : {false, true}) {
      const double at = upper ? domain.upper[d] : domain.lower[d], face = upper ? body.upper[d] : body.lower[d];
      if (std::abs(at - face) > near) continue;
      const auto first = static_cast<std::uint8_t>(upper ? 1u << d : 0u);
      const auto second = static_cast<std::uint8_t>(first | 1u << along);
      SurfaceEdge edge{particle, {first, second}, {}, {corner(first), corner(second)}};
      edge.N_dA[d] = (upper ? 1 : -1) * (domain.upper[along] - domain.lower[along]);
      edges.push_back(edge);
    }
  }
}

}  // namespace assay::mpm
