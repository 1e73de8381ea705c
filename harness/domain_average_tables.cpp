// SPDX-License-Identifier: BSD-3-Clause
// What the average over the reference domains computes before the first step.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "harness/domain_average.hpp"
#include "harness/gauss.hpp"

namespace assay {

namespace {

constexpr int panel_nodes = 7;    ///< of the acceleration's interpolation in R
constexpr int fewest_panels = 8;  ///< across the ring

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

/// Lagrange weights of the panel's nodes at x in [-1, 1].
std::array<double, panel_nodes> lagrange(double x) {
  const auto& node = gauss_rule<panel_nodes>();
  static const std::array<double, panel_nodes> scale = [&] {
    std::array<double, panel_nodes> factors;
    factors.fill(1);
    for (std::size_t i = 0; i < panel_nodes; ++i) {
      for (std::size_t j = 0; j < panel_nodes; ++j) {
        if (j != i) factors[i] /= node[i].at - node[j].at;
      }
    }
    return factors;
  }();
  std::array<double, panel_nodes> weight = scale;
  double left = 1, right = 1;  // products of x - node[j] on both sides of i
  for (std::size_t i = 0; i < panel_nodes; ++i) {
    weight[i] *= left;
    left *= x - node[i].at;
    const std::size_t k = panel_nodes - 1 - i;
    weight[k] *= right;
    right *= x - node[k].at;
  }
  return weight;
}

}  // namespace

DomainAverage::DomainAverage(const Vortex& vortex, double density, const ReferenceDomains& domains, int gauss_points)
    : vortex_(vortex), density_(density), gauss_points_(gauss_points), radii_of_xi_(vortex), places_(domains.places) {
  add_edges(domains);
  add_weights(domains);
  tau_.resize(4 * xi_.size());
  rotated_.resize(xi_.size());
  flux_.resize(edges_.size());
  node_a_.resize(node_h_.size());
  force_.resize(shapes_.size());
}

/// Gauss points of the straight piece a b inside the ring; the normal points to the right of the way from a to b.
void DomainAverage::add_points(const Point& a, const Point& b, std::vector<BoundaryPoint>& points,
                               std::vector<double>& radius) const {
  const double dx = 0.5 * (b[0] - a[0]), dy = 0.5 * (b[1] - a[1]);
  for (const GaussPoint& gauss : rule_of(gauss_points_)) {
    const double x = 0.5 * (a[0] + b[0]) + gauss.at * dx, y = 0.5 * (a[1] + b[1]) + gauss.at * dy;
    const double R = std::hypot(x, y), c = x / R, s = y / R, w = gauss.weight;
    points.push_back({c, s, w * (c * dy - s * dx), w * (-s * dy - c * dx), 0});  // N dS = (dy, -dx)
    radius.push_back(R);
  }
}

/// An arc: tau and alpha are constant along it, and E_R is integrated exactly.
std::uint32_t DomainAverage::add_arc(const BoundaryPiece& arc, std::vector<double>& radius) {
  const auto begin = static_cast<std::uint32_t>(points_.size());
  const double R = arc.radius, middle = arc.from + 0.5 * arc.sweep;
  points_.push_back({std::cos(middle), std::sin(middle), 2 * R * std::sin(0.5 * arc.sweep), 0, 0});
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
void DomainAverage::add_edges(const ReferenceDomains& domains) {
  std::unordered_map<std::array<double, 4>, std::uint32_t, PositionHash> known;
  std::vector<double> radius;
  for (const auto& shape : domains.shapes) {
    Shape mine;
    mine.volume = shape.volume;
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

void DomainAverage::share_radii(std::vector<double>& radius) {
  std::vector<double> distinct = radius;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  for (std::size_t i = 0; i < radius.size(); ++i) {
    points_[i].radius =
        static_cast<std::uint32_t>(std::lower_bound(distinct.begin(), distinct.end(), radius[i]) - distinct.begin());
  }
  for (const double R : distinct) {
    const Vortex::Profile profile = vortex_.profile(R);
    xi_.push_back(profile.xi);
    h_.push_back(profile.h);
  }
}

/// The acceleration (29) is X f(R, t): f is interpolated between radial nodes that all shapes share, in panels no wider
/// than a whole domain.
int DomainAverage::lay_out_panels() {
  const double ri = vortex_.inner, width = vortex_.outer - vortex_.inner;
  double largest_volume = 0;
  for (const Shape& shape : shapes_) largest_volume = std::max(largest_volume, shape.volume);
  double panel = width / fewest_panels;
  if (largest_volume > 0) panel = std::min(panel, std::sqrt(largest_volume));
  const int panels = static_cast<int>(std::ceil(width / panel - 1e-9));
  for (int k = 0; k < panels; ++k) {
    for (const GaussPoint& node : gauss_rule<panel_nodes>()) {
      node_h_.push_back(vortex_.profile(ri + width * (k + 0.5 * (1 + node.at)) / panels).h);
    }
  }
  return panels;
}

/// The integral of X times each node's polynomial, over every shape.
void DomainAverage::add_weights(const ReferenceDomains& domains) {
  const int panels = lay_out_panels();
  const double ri = vortex_.inner, scale = panels / (vortex_.outer - vortex_.inner);
  std::vector<Point> sums(node_h_.size(), Point{});
  for (std::size_t k = 0; k < shapes_.size(); ++k) {
    std::size_t low = sums.size(), high = 0;
    for_each_area_point(domains.shapes[k].boundary, [&](const Point& X, double w) {
      const double at = (std::hypot(X[0], X[1]) - ri) * scale;
      const int panel = std::clamp(static_cast<int>(at), 0, panels - 1);
      const auto value = lagrange(2 * (at - panel) - 1);
      const auto first = static_cast<std::size_t>(panel * panel_nodes);
      low = std::min(low, first), high = std::max(high, first + panel_nodes);
      for (std::size_t i = 0; i < panel_nodes; ++i) {
        for (std::size_t d = 0; d < 2; ++d) sums[first + i][d] += w * value[i] * X[d];
      }
    });
    Shape& shape = shapes_[k];
    shape.weights_begin = static_cast<std::uint32_t>(weights_.size());
    shape.node = static_cast<std::uint32_t>(std::min(low, high));
    for (std::size_t i = low; i < high; ++i) weights_.push_back(std::exchange(sums[i], Point{}));
    shape.weights_end = static_cast<std::uint32_t>(weights_.size());
  }
}

}  // namespace assay
