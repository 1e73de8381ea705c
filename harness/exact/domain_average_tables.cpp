// SPDX-License-Identifier: BSD-3-Clause
// What the average over the reference domains computes before the first step.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "harness/exact/domain_average.hpp"
#include "harness/numeric/gauss.hpp"

namespace assay {

namespace {

std::span<const GaussPoint> rule_of(int points) {
  switch (points) {
    case 1:
      return gauss_rule<1>();
    case 2:
      return gauss_rule<2>();
    case 3:
      return gauss_rule<3>();
    case 4:
      return gauss_rule<4>();
    case 5:
      return gauss_rule<5>();
    case 6:
      return gauss_rule<6>();
    case 7:
      return gauss_rule<7>();
    case 8:
      return gauss_rule<8>();
    default:
      throw std::invalid_argument("DomainAverage: 1 to 8 Gauss points");
  }
}

double nearest_radius(const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double s = std::clamp(-(a[0] * dx + a[1] * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a[0] + s * dx, a[1] + s * dy);
}

}  // namespace

DomainAverage::DomainAverage(const Motion& motion, double density, const ReferenceDomains& domains, int gauss_points)
    : motion_(motion),
      gauss_points_(gauss_points),
      radii_of_xi_(radii_of_parameter(motion)),
      places_(domains.places),
      moments_(*ring_of(motion), domains),
      nodes_(motion, moments_.nodes()) {
  add_edges(domains, density);
  tau_.resize(4 * xi_.size());
  rotated_.resize(xi_.size());
  flux_.resize(edges_.size());
  node_a_.resize(nodes_.size());
  force_.resize(shapes_.size());
}

/// Gauss points of the straight piece a b inside the ring; the normal points to the right of the way from a to b.
void DomainAverage::add_points(const Point& a, const Point& b, std::vector<BoundaryPoint>& points,
                               std::vector<double>& radius) const {
  const double dx = 0.5 * (b[0] - a[0]), dy = 0.5 * (b[1] - a[1]);
  for (const GaussPoint& gauss : rule_of(gauss_points_)) {
    const double x = 0.5 * (a[0] + b[0]) + gauss.at * dx, y = 0.5 * (a[1] + b[1]) + gauss.at * dy;
    const double R = std::hypot(x, y), c = x / R, s = y / R, w = gauss.weight;
    points.push_back({{c, s}, {w * (c * dy - s * dx), w * (-s * dy - c * dx)}});  // N dS = (dy, -dx)
    radius.push_back(R);
  }
}

/// An arc: tau and alpha are constant along it, and E_R is integrated exactly.
std::uint32_t DomainAverage::add_arc(const BoundaryPiece& arc, std::vector<double>& radius) {
  const auto begin = static_cast<std::uint32_t>(points_.size());
  const double R = arc.radius, middle = arc.from + 0.5 * arc.sweep;
  points_.push_back({{std::cos(middle), std::sin(middle)}, {2 * R * std::sin(0.5 * arc.sweep), 0}});
  radius.push_back(R);
  edges_.push_back({begin, begin + 1, arc.a, arc.b, R, R});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

std::uint32_t DomainAverage::add_straight(const Point& a, const Point& b, std::vector<double>& radius) {
  const auto begin = static_cast<std::uint32_t>(points_.size());
  add_points(a, b, points_, radius);
  edges_.push_back({begin, static_cast<std::uint32_t>(points_.size()), a, b, nearest_radius(a, b),
                    std::max(std::hypot(a[0], a[1]), std::hypot(b[0], b[1]))});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

/// Edges that two shapes share are integrated once: kept from their lower end to the upper one.
void DomainAverage::add_edges(const ReferenceDomains& domains, double density) {
  std::unordered_map<std::array<double, 4>, std::uint32_t, PositionHash> known;
  std::vector<double> radius;
  for (const auto& shape : domains.shapes) {
    Shape mine;
    mine.of_inertia = 1 / shape.volume;
    mine.of_flux = -1 / (density * shape.volume);
    mine.sides_begin = static_cast<std::uint32_t>(sides_.size());
    for (const BoundaryPiece& piece : shape.boundary) {
      if (!piece.straight()) {  // where the domain goes on beyond, the jump of T.N to 0 is part of the average
        if (shape.arcs_are_cuts) sides_.push_back({add_arc(piece, radius), 1});
        continue;
      }
      const bool turned = piece.b < piece.a;
      const Point &a = turned ? piece.b : piece.a, &b = turned ? piece.a : piece.b;
      const auto [it, is_new] = known.try_emplace({a[0], a[1], b[0], b[1]}, 0);
      if (is_new) it->second = add_straight(a, b, radius);
      sides_.push_back({it->second, turned ? -1.0 : 1.0});
    }
    mine.sides_end = static_cast<std::uint32_t>(sides_.size());
    shapes_.push_back(mine);
  }
  share_radii(radius);
}

/// In the order of the edges, so that those of neighbours stand side by side.
void DomainAverage::share_radii(std::span<const double> radius) {
  std::unordered_map<double, std::uint32_t> known;
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const auto [it, is_new] = known.try_emplace(radius[i], static_cast<std::uint32_t>(xi_.size()));
    points_[i].radius = it->second;
    if (!is_new) continue;
    const RingParameter parameter = ring_parameter(motion_, radius[i]);
    xi_.push_back(parameter.value);
    h_.push_back(parameter.h);
  }
}

}  // namespace assay
