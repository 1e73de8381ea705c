// SPDX-License-Identifier: BSD-3-Clause
// Lattices that follow a ring.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mpm/seeding/cell_counts.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

/// All lattice cells of the square around the ring that may have a part in it.
std::vector<Rectangle> cells_around(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell) {
  std::array<double, 2> half{};
  std::array<std::int64_t, 2> reach{};
  for (std::size_t d = 0; d < 2; ++d) {
    half[d] = 0.5 * spacing / per_cell[d];
    reach[d] = static_cast<std::int64_t>(cell_above(ring.outer, spacing)) * per_cell[d];
  }
  const auto corner = [&](std::size_t d, std::int64_t i) { return 2.0 * static_cast<double>(i) * half[d]; };
  std::vector<Rectangle> cells;
  for (std::int64_t j = -reach[1]; j < reach[1]; ++j) {
    for (std::int64_t i = -reach[0]; i < reach[0]; ++i) {
      const Rectangle cell{{corner(0, i), corner(1, j)}, {corner(0, i + 1), corner(1, j + 1)}};
      const auto near = [&](std::size_t d) { return std::min(std::abs(cell.lower[d]), std::abs(cell.upper[d])); };
      const auto far = [&](std::size_t d) { return std::max(std::abs(cell.lower[d]), std::abs(cell.upper[d])); };
      if (std::hypot(near(0), near(1)) < ring.outer && std::hypot(far(0), far(1)) > ring.inner) cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace

Seeds<2> clipped_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell) {
  Seeds<2> seeds;
  for (std::size_t d = 0; d < 2; ++d) seeds.half_size[d] = 0.5 * spacing / per_cell[d];
  ReferenceDomains domains = domains_of(cells_around(ring, spacing, per_cell), ring, true);
  std::vector<Point> centroids;
  for (const auto& shape : domains.shapes) centroids.push_back(moments_of(shape.boundary).centroid);
  const double least = multiple_rounding * seeds.volume();
  std::erase_if(domains.places, [&](const auto& place) { return !(domains.shapes[place.shape].volume > least); });
  for (const auto& place : domains.places) {
    const Point X = place.turned(centroids[place.shape]);
    seeds.X[0].push_back(X[0]);
    seeds.X[1].push_back(X[1]);
    seeds.volumes.push_back(domains.shapes[place.shape].volume);
  }
  seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  return seeds;
}

Seeds<2> polar_lattice(const Annulus& ring, double spacing, const std::array<int, 2>& per_cell, bool share_corners) {
  Seeds<2> seeds;
  for (std::size_t d = 0; d < 2; ++d) seeds.half_size[d] = 0.5 * spacing / per_cell[d];
  const double width = ring.outer - ring.inner;
  const int rings = static_cast<int>(std::ceil(width / (2 * seeds.half_size[0]) - multiple_rounding));
  std::vector<Sector> sectors;
  std::vector<int> count;
  for (int k = 0; k < rings; ++k) {
    const double inner = ring.inner + width * k / rings, outer = ring.inner + width * (k + 1) / rings;
    const double quarter = 0.25 * std::numbers::pi * (share_corners ? ring.inner + ring.outer : inner + outer);
    count.push_back(4 * static_cast<int>(std::ceil(quarter / (2 * seeds.half_size[1]) - multiple_rounding)));
    const double half = std::numbers::pi / count.back();
    sectors.push_back({inner, outer, -half, half});
  }
  ReferenceDomains domains = domains_of(sectors, count);
  for (const auto& place : domains.places) {
    const Sector& s = sectors[place.shape];
    const double volume = domains.shapes[place.shape].volume, half = 0.5 * (s.outer - s.inner);
    const double R = 4.0 / 3 * (std::pow(s.outer, 3) - std::pow(s.inner, 3)) /
                     ((s.outer - s.inner) * (s.outer + s.inner)) * std::sin(s.end) / (s.end - s.begin);  // centroid
    const double c = place.cos_turn, si = place.sin_turn, across = 0.25 * volume / half;
    seeds.X[0].push_back(R * c);
    seeds.X[1].push_back(R * si);
    seeds.volumes.push_back(volume);
    seeds.half_edges.push_back({half * c, -across * si, half * si, across * c});  // along E_R, E_Theta
    if (!share_corners) continue;
    const auto corner = [&](double radius, double angle) {
      return place.turned({radius * std::cos(angle), radius * std::sin(angle)});
    };
    seeds.corners.push_back(
        {corner(s.inner, s.begin), corner(s.outer, s.begin), corner(s.inner, s.end), corner(s.outer, s.end)});
  }
  seeds.domains = std::make_shared<const ReferenceDomains>(std::move(domains));
  return seeds;
}

ReferenceDomains rectangles_of(const Seeds<2>& seeds, const Annulus& ring) {
  return domains_of(rectangles_around(seeds.X[0], seeds.X[1], seeds.half_size), ring, false);
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
