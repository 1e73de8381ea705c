// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/reference_domain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "harness/numeric/gauss.hpp"

namespace assay {

namespace {

/// Crossings this close to an edge's end [relative to the edge] are at the end.
constexpr double snap = 1e-13;
constexpr double two_pi = 2 * std::numbers::pi;

double norm(const Point& p) { return std::hypot(p[0], p[1]); }
Point on_circle(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

/// RectangleEdge k of a rectangle, counterclockwise from the lower one.
struct RectangleEdge {
  Point a, b;
  std::size_t along;  ///< direction in which it runs
};
std::array<RectangleEdge, 4> edges_of(const Rectangle& r) {
  const Point p00 = r.lower, p10{r.upper[0], r.lower[1]}, p11 = r.upper, p01{r.lower[0], r.upper[1]};
  return {RectangleEdge{p00, p10, 0}, RectangleEdge{p10, p11, 1}, RectangleEdge{p11, p01, 0},
          RectangleEdge{p01, p00, 1}};
}

/// Points at which an axis-parallel edge meets a circle; snapped to the edge's ends.
void meet(const RectangleEdge& edge, double radius, std::vector<Point>& points) {
  const double across = edge.a[1 - edge.along];
  if (!(std::abs(across) <= radius)) return;
  const double root = std::sqrt((radius - across) * (radius + across));
  const double low = std::min(edge.a[edge.along], edge.b[edge.along]);
  const double high = std::max(edge.a[edge.along], edge.b[edge.along]);
  const double near = snap * (high - low);
  for (const double at : {-root, root}) {
    if (at < low - near || at > high + near) continue;
    Point p = edge.a;
    p[edge.along] = std::abs(at - low) <= near ? low : std::abs(at - high) <= near ? high : at;
    points.push_back(p);
    if (root == 0) break;
  }
}

void add_edge_parts(const RectangleEdge& edge, const Annulus& ring, Boundary& boundary) {
  std::vector<Point> cuts{edge.a, edge.b};
  meet(edge, ring.inner, cuts);
  meet(edge, ring.outer, cuts);
  const double sign = edge.b[edge.along] > edge.a[edge.along] ? 1 : -1;
  std::sort(cuts.begin(), cuts.end(),
            [&](const Point& p, const Point& q) { return sign * p[edge.along] < sign * q[edge.along]; });
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Point &p = cuts[k], &q = cuts[k + 1];
    if (p == q) continue;
    const double R = norm({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
    if (R > ring.inner && R < ring.outer) boundary.push_back({p, q});
  }
}

/// Arcs of a circle inside the rectangle; counterclockwise where the domain lies within the circle.
void add_arcs(const Rectangle& r, double radius, bool within, Boundary& boundary) {
  std::vector<Point> cuts;
  for (const RectangleEdge& edge : edges_of(r)) meet(edge, radius, cuts);
  std::vector<std::pair<double, Point>> at;
  for (const Point& p : cuts) at.emplace_back(std::atan2(p[1], p[0]), p);
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  if (at.empty()) at.emplace_back(0, Point{radius, 0});  // all of the circle, or none of it
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto& [from, a] = at[k];
    const auto& [to, b] = at[(k + 1) % at.size()];
    const double sweep = k + 1 < at.size() ? to - from : to - from + two_pi;
    const Point middle = on_circle(radius, from + 0.5 * sweep);
    const bool inside =
        middle[0] > r.lower[0] && middle[0] < r.upper[0] && middle[1] > r.lower[1] && middle[1] < r.upper[1];
    if (!inside) continue;
    if (within) {
      boundary.push_back({a, b, radius, from, sweep});
    } else {
      boundary.push_back({b, a, radius, from + sweep, -sweep});
    }
  }
}

/// x - sin x, also where it is small.
double minus_sine(double x) {
  if (std::abs(x) > 0.5) return x - std::sin(x);
  double term = x * x * x / 6, sum = term;
  for (int k = 4; std::abs(term) > 1e-18 * std::abs(sum); k += 2) sum += term *= -x * x / (k * (k + 1));
  return sum;
}

/// Area and first moments about a point near by, so that a sliver's are as good as its corners.
void add_moments(const BoundaryPiece& piece, const Point& about, double& area, Point& first) {
  const Point a{piece.a[0] - about[0], piece.a[1] - about[1]}, b{piece.b[0] - about[0], piece.b[1] - about[1]};
  const double triangle = 0.5 * (a[0] * b[1] - a[1] * b[0]);
  area += triangle;
  for (std::size_t d = 0; d < 2; ++d) first[d] += triangle * (a[d] + b[d]) / 3;
  if (piece.straight()) return;
  const double R = piece.radius, segment = 0.5 * R * R * minus_sine(piece.sweep);  // between chord and arc
  const double arm = 2.0 / 3 * std::pow(R * std::sin(0.5 * piece.sweep), 3);       // its moment about the origin
  const Point e = on_circle(1, piece.from + 0.5 * piece.sweep);
  area += segment;
  for (std::size_t d = 0; d < 2; ++d) first[d] += arm * e[d] - segment * about[d];
}

}  // namespace

Boundary common_boundary(const Rectangle& rectangle, const Annulus& ring) {
  Boundary boundary;
  for (const RectangleEdge& edge : edges_of(rectangle)) add_edge_parts(edge, ring, boundary);
  add_arcs(rectangle, ring.inner, false, boundary);
  add_arcs(rectangle, ring.outer, true, boundary);
  return boundary;
}

Boundary boundary_of(const Sector& s) {
  const double sweep = s.end - s.begin;
  const Point inner_begin = on_circle(s.inner, s.begin), inner_end = on_circle(s.inner, s.end);
  const Point outer_begin = on_circle(s.outer, s.begin), outer_end = on_circle(s.outer, s.end);
  return {{inner_begin, outer_begin},
          {outer_begin, outer_end, s.outer, s.begin, sweep},
          {outer_end, inner_end},
          {inner_end, inner_begin, s.inner, s.end, -sweep}};
}

AreaMoments moments_of(const Boundary& boundary) {
  AreaMoments m;
  if (boundary.empty()) return m;
  const Point about = boundary.front().a;
  Point first{};
  for (const BoundaryPiece& piece : boundary) add_moments(piece, about, m.area, first);
  if (!(m.area > 0)) return {};
  m.centroid = {about[0] + first[0] / m.area, about[1] + first[1] / m.area};
  return m;
}

namespace {

/// The corners, where the boundary is that of a whole axis-aligned rectangle.
std::optional<Rectangle> as_rectangle(const Boundary& boundary) {
  if (boundary.size() != 4) return std::nullopt;
  Rectangle r{boundary[0].a, boundary[0].a};
  for (const BoundaryPiece& piece : boundary) {
    if (!piece.straight() || (piece.a[0] != piece.b[0] && piece.a[1] != piece.b[1])) return std::nullopt;
    for (std::size_t d = 0; d < 2; ++d) {
      r.lower[d] = std::min(r.lower[d], piece.a[d]);
      r.upper[d] = std::max(r.upper[d], piece.a[d]);
    }
  }
  return r;
}

}  // namespace

void for_each_area_point(const Boundary& boundary, const std::function<void(const Point&, double)>& visit) {
  if (const auto r = as_rectangle(boundary)) {  // the most frequent domain, in fewer points
    const Point half{0.5 * (r->upper[0] - r->lower[0]), 0.5 * (r->upper[1] - r->lower[1])};
    for (const GaussPoint& y : gauss_rule<5>()) {
      for (const GaussPoint& x : gauss_rule<5>()) {
        visit({r->lower[0] + (1 + x.at) * half[0], r->lower[1] + (1 + y.at) * half[1]},
              half[0] * half[1] * x.weight * y.weight);
      }
    }
    return;
  }
  double least = HUGE_VAL;  // radius from which on all integrals are taken: cancels over the closed boundary
  for (const BoundaryPiece& piece : boundary) {
    least = std::min({least, norm(piece.a), norm(piece.b)});
    if (piece.straight())
      least = std::min(least, norm({0.5 * (piece.a[0] + piece.b[0]), 0.5 * (piece.a[1] + piece.b[1])}));
  }
  const auto& rule = gauss_rule<6>();
  for (const BoundaryPiece& piece : boundary) {
    for (const GaussPoint& along : rule) {
      const double s = 0.5 * (1 + along.at);
      const Point p = piece.straight() ? Point{piece.a[0] + s * (piece.b[0] - piece.a[0]),
                                               piece.a[1] + s * (piece.b[1] - piece.a[1])}
                                       : on_circle(piece.radius, piece.from + s * piece.sweep);
      const double R = norm(p);
      const double turn = piece.straight() ? (piece.a[0] * piece.b[1] - piece.a[1] * piece.b[0]) / (R * R)
                                           : piece.sweep;  // d Theta / d s
      for (const GaussPoint& radial : rule) {
        const double rho = least + 0.5 * (1 + radial.at) * (R - least);
        const double weight = 0.25 * along.weight * turn * radial.weight * (R - least) * rho;
        if (weight != 0) visit({p[0] * rho / R, p[1] * rho / R}, weight);
      }
    }
  }
}

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

Interval side_around(double middle, double half) {
  const double odd = std::round(middle / half);
  const bool on_lattice = std::abs(middle - odd * half) <= 1e-12 * std::abs(middle);
  return on_lattice ? Interval{(odd - 1) * half, (odd + 1) * half} : Interval{middle - half, middle + half};
}

std::vector<Rectangle> rectangles_around(std::span<const double> X, std::span<const double> Y, const Point& half) {
  std::vector<Rectangle> rectangles(X.size());
  for (std::size_t p = 0; p < X.size(); ++p) {
    const Interval along_X = side_around(X[p], half[0]), along_Y = side_around(Y[p], half[1]);
    rectangles[p] = {{along_X.lower, along_Y.lower}, {along_X.upper, along_Y.upper}};
  }
  return rectangles;
}

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
