// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "harness/exact/reference_domain.hpp"

namespace assay {

namespace {

/// Quarter turns that take the rectangle's centre into the first quadrant; 0 where it straddles an axis.
int quarter_of(const Rectangle& r) {
  const bool right = r.lower[0] >= 0, left = r.upper[0] <= 0, above = r.lower[1] >= 0, below = r.upper[1] <= 0;
  if (left && above) return 1;
  if (left && below) return 2;
  if (right && below) return 3;
  return 0;
}

constexpr int cosine[] = {1, 0, -1, 0}, sine[] = {0, 1, 0, -1};  // of quarter turns

Rectangle turned_back(const Rectangle& r, int quarters) {
  const auto back = [&](const Point& p) {
    const double c = cosine[quarters], s = sine[quarters];
    return Point{c * p[0] + s * p[1] + 0.0, -s * p[0] + c * p[1] + 0.0};
  };
  const Point p = back(r.lower), q = back(r.upper);
  return {{std::min(p[0], q[0]), std::min(p[1], q[1])}, {std::max(p[0], q[0]), std::max(p[1], q[1])}};
}

}  // namespace

ReferenceDomains domains_of(std::span<const Rectangle> rectangles, const Annulus& ring, bool clipped) {
  ReferenceDomains domains;
  std::unordered_map<std::array<double, 4>, std::uint32_t, PositionHash> known;
  for (const Rectangle& rectangle : rectangles) {
    const int quarters = quarter_of(rectangle);
    const Rectangle r = turned_back(rectangle, quarters);
    const auto [it, is_new] = known.try_emplace({r.lower[0], r.lower[1], r.upper[0], r.upper[1]},
                                                static_cast<std::uint32_t>(domains.shapes.size()));
    if (is_new) {
      ReferenceDomains::Shape shape{common_boundary(r, ring), r.area(), clipped};
      if (clipped) shape.volume = moments_of(shape.boundary).area;
      domains.shapes.push_back(std::move(shape));
    }
    domains.places.push_back({it->second, double(cosine[quarters]), double(sine[quarters])});
  }
  return domains;
}

ReferenceDomains domains_of(std::span<const Sector> sectors, std::span<const int> count) {
  ReferenceDomains domains;
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    const Sector& s = sectors[k];
    const double volume = 0.5 * (s.outer - s.inner) * (s.outer + s.inner) * (s.end - s.begin);
    domains.shapes.push_back({boundary_of(s), volume, true});
    const int n = count[k], quarter = n % 4 == 0 ? n / 4 : n;
    for (int j = 0; j < n; ++j) {  // images under quarter turns to the last bit
      const double angle = 2 * std::numbers::pi * (j % quarter + 0.5) / n;
      const double c = std::cos(angle), si = std::sin(angle);
      const int q = j / quarter;
      domains.places.push_back(
          {static_cast<std::uint32_t>(k), cosine[q] * c - sine[q] * si, sine[q] * c + cosine[q] * si});
    }
  }
  return domains;
}

}  // namespace assay
