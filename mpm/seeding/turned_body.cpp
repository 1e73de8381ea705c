// SPDX-License-Identifier: BSD-3-Clause
// Bodies that are turned against the grid.
#include <cmath>

#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

void turn(Seeds<2>& seeds, double angle, bool half_edges) {
  const ReferenceDomains::Place by{0, std::cos(angle), std::sin(angle)};
  if (seeds.domains) {
    ReferenceDomains domains = *seeds.domains;
    for (auto& place : domains.places) {
      const Point direction = by.turned({place.cos_turn, place.sin_turn});
      place.cos_turn = direction[0], place.sin_turn = direction[1];
    }
    seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  }
  if (half_edges && seeds.half_edges.empty()) {
    seeds.half_edges.assign(seeds.size(), {seeds.half_size[0], 0, 0, seeds.half_size[1]});
  }
  for (auto& H : seeds.half_edges) {
    const Point first = by.turned({H[0], H[2]}), second = by.turned({H[1], H[3]});
    H = {first[0], second[0], first[1], second[1]};
  }
  for (auto& corners : seeds.corners) {
    for (Point& X : corners) X = by.turned(X);
  }
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const Point X = by.turned({seeds.X[0][p], seeds.X[1][p]});
    seeds.X[0][p] = X[0], seeds.X[1][p] = X[1];
  }
  for (auto& X : seeds.held) X = by.turned(X);
  if (!half_edges && seeds.half_size[0] != seeds.half_size[1]) seeds.half_size.fill(0.5 * std::sqrt(seeds.volume()));
  seeds.angle += angle;
}

void turn(Seeds<3>& seeds, const Tensor& R, bool half_edges) {
  const auto turned = [&](const std::array<double, 3>& X) {
    const Vector3 x = R * Vector3(X[0], X[1], X[2]);
    return std::array{x.x(), x.y(), x.z()};
  };
  if (seeds.domains) {
    std::vector<std::array<Vector3, 8>> domains;
    for (const Hexahedra::Domain& domain : seeds.domains->domains()) {
      auto& corners = domains.emplace_back();
      for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = R * seeds.domains->corners()[domain.corners[k]];
    }
    seeds.domains = std::make_shared<const Hexahedra>(domains);
  }
  if (half_edges) {
    std::array<double, 9> H{};
    for (int i = 0; i < 3; ++i) {
      for (int d = 0; d < 3; ++d)
        H[static_cast<std::size_t>(3 * i + d)] = R(i, d) * seeds.half_size[static_cast<std::size_t>(d)];
    }
    seeds.half_edges.assign(seeds.size(), H);
  }
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const auto X = turned({seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]});
    for (std::size_t d = 0; d < 3; ++d) seeds.X[d][p] = X[d];
  }
  for (auto& X : seeds.held) X = turned(X);
  for (SurfacePiece<3>& piece : seeds.surface) {
    piece.N_dA = turned(piece.N_dA), piece.middle = turned(piece.middle);
    for (auto& X : piece.X) X = turned(X);
  }
  if (!half_edges) seeds.half_size.fill(0.5 * std::cbrt(seeds.volume()));
}

}  // namespace assay::mpm
