// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/polar_average.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "harness/numeric/sine_cosine.hpp"
#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

/// A front this close to an edge's end [relative to ro] is at its end.
constexpr double front_snap = 1e-12;

/// S = Q(g h) tau - rest I at radii first to last - 1 of n; tau[c * n + i]. A uniform stress has no resultant on a
/// closed boundary, and without it S is zero outside the ring, where no edge is integrated.
ASSAY_VECTOR_CLONES void rotate(double g, double rest, const double* __restrict h, const double* __restrict tau,
                                std::size_t n, std::size_t first, std::size_t last,
                                PolarAverage::Rotated* __restrict out) {
  const double *t11 = tau, *t12 = t11 + n, *t21 = t12 + n, *t22 = t21 + n;
  for (std::size_t i = first; i < last; ++i) {
    double c = 1, s = 0;
    sine_cosine(g * h[i], s, c);
    out[i].s11 = c * t11[i] - s * t21[i] - rest;
    out[i].s12 = c * t12[i] - s * t22[i];
    out[i].s21 = s * t11[i] + c * t21[i];
    out[i].s22 = s * t12[i] + c * t22[i] - rest;
  }
}

double nearest_radius(const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  const double s = std::clamp(-(a[0] * dx + a[1] * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a[0] + s * dx, a[1] + s * dy);
}

}  // namespace

PolarAverage::PolarAverage(const Motion& motion, double density, const ReferenceDomains& domains,
                           std::span<const GaussPoint> rule, double rest)
    : motion_(motion),
      rest_(rest),
      rule_(rule.begin(), rule.end()),
      radii_of_xi_(motion->polar()->radii_of_parameter()),
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
void PolarAverage::add_points(const Point& a, const Point& b, std::vector<BoundaryPoint>& points,
                              std::vector<double>& radius) const {
  const double dx = 0.5 * (b[0] - a[0]), dy = 0.5 * (b[1] - a[1]);
  for (const GaussPoint& gauss : rule_) {
    const double x = 0.5 * (a[0] + b[0]) + gauss.at * dx, y = 0.5 * (a[1] + b[1]) + gauss.at * dy;
    const double R = std::hypot(x, y), c = x / R, s = y / R, w = gauss.weight;
    points.push_back({{c, s}, {w * (c * dy - s * dx), w * (-s * dy - c * dx)}});  // N dS = (dy, -dx)
    radius.push_back(R);
  }
}

/// An arc: tau and alpha are constant along it, and E_R is integrated exactly.
std::uint32_t PolarAverage::add_arc(const BoundaryPiece& arc, std::vector<double>& radius) {
  const auto begin = static_cast<std::uint32_t>(points_.size());
  const double R = arc.radius, middle = arc.from + 0.5 * arc.sweep;
  points_.push_back({{std::cos(middle), std::sin(middle)}, {2 * R * std::sin(0.5 * arc.sweep), 0}});
  radius.push_back(R);
  edges_.push_back({begin, begin + 1, arc.a, arc.b, R, R});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

std::uint32_t PolarAverage::add_straight(const Point& a, const Point& b, std::vector<double>& radius) {
  const auto begin = static_cast<std::uint32_t>(points_.size());
  add_points(a, b, points_, radius);
  edges_.push_back({begin, static_cast<std::uint32_t>(points_.size()), a, b, nearest_radius(a, b),
                    std::max(std::hypot(a[0], a[1]), std::hypot(b[0], b[1]))});
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

/// Edges that two shapes share are integrated once: kept from their lower end to the upper one.
void PolarAverage::add_edges(const ReferenceDomains& domains, double density) {
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
void PolarAverage::share_radii(std::span<const double> radius) {
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

/// Products with n1 stand beside those with n2 and are added up in the end.
Point PolarAverage::flux_of(std::span<const BoundaryPoint> points, std::span<const Rotated> S) const {
  using Two = double __attribute__((vector_size(2 * sizeof(double))));
  Two flux_x{}, flux_y{};
  for (const BoundaryPoint& p : points) {
    const Rotated& s = S[p.radius];
    const Two x{p.along_x[0], p.along_x[1]}, y{p.along_y[0], p.along_y[1]}, along_R{s.s11, s.s12},
        along_Theta{s.s21, s.s22};
    flux_x += x * along_R - y * along_Theta;
    flux_y += y * along_R + x * along_Theta;
  }
  return {flux_x[0] + flux_x[1], flux_y[0] + flux_y[1]};
}

/// Where |a + s (b - a)| takes one of the radii, s in (0, 1), with 0 and 1 around; empty where it takes none.
void PolarAverage::cuts_of(const Edge& edge, std::span<const double> radii, std::vector<double>& cuts) const {
  const double near = front_snap * motion_->polar()->ring().outer;
  const Point &a = edge.a, d{edge.b[0] - a[0], edge.b[1] - a[1]};
  const double dd = d[0] * d[0] + d[1] * d[1], ad = a[0] * d[0] + a[1] * d[1];
  cuts.clear();
  for (const double R : radii) {
    if (!(R > edge.nearest + near && R < edge.farthest - near)) continue;
    const double root = std::sqrt(std::max(0.0, ad * ad - dd * (a[0] * a[0] + a[1] * a[1] - R * R)));
    for (const double s : {(-ad - root) / dd, (-ad + root) / dd}) {
      if (s > 0 && s < 1) cuts.push_back(s);
    }
  }
  if (cuts.empty()) return;
  cuts.insert(cuts.end(), {0.0, 1.0});
  std::sort(cuts.begin(), cuts.end());
}

/// Integrates edges that a front crosses once more, piece by piece.
void PolarAverage::split_at_fronts(const ResponseAtTime& response, double g) {
  std::vector<double> radii, radius, cuts;
  for (const double xi : response.fronts()) {
    for (const double R : radii_of_xi_(xi)) radii.push_back(R);
  }
  if (radii.empty()) return;
  std::vector<BoundaryPoint> points;
  std::vector<std::pair<std::size_t, std::size_t>> split;  // edge and the end of its points
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Point &a = edges_[e].a, &b = edges_[e].b;
    cuts_of(edges_[e], radii, cuts);
    const auto at = [&](double s) { return Point{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}; };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      if (cuts[k + 1] > cuts[k]) add_points(at(cuts[k]), at(cuts[k + 1]), points, radius);
    }
    if (!cuts.empty()) split.emplace_back(e, points.size());
  }
  const std::vector<Rotated> S = rotated_at(response, g, radius);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].radius = static_cast<std::uint32_t>(i);
  std::size_t begin = 0;
  for (const auto& [e, end] : split) {
    flux_[e] = flux_of(std::span(points).subspan(begin, end - begin), S);
    begin = end;
  }
}

std::vector<PolarAverage::Rotated> PolarAverage::rotated_at(const ResponseAtTime& response, double g,
                                                            std::span<const double> radius) const {
  const std::size_t n = radius.size();
  std::vector<double> xi(n), h(n), tau(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const RingParameter parameter = ring_parameter(motion_, radius[i]);
    xi[i] = parameter.value, h[i] = parameter.h;
  }
  response.plane_tau(xi, tau, in_one_piece);
  std::vector<Rotated> S(n);
  rotate(g, rest_, h.data(), tau.data(), n, 0, n, S.data());
  return S;
}

/// f of a = X f, (29) of the vortex, at the radial nodes.
void PolarAverage::accelerations(double t) {
  nodes_.set_time(t);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const RingKinematics ring = nodes_[k];
    const Polar a = ring.acceleration();
    const double c = std::cos(ring.alpha), s = std::sin(ring.alpha), R = nodes_.radius(k);
    node_a_[k] = {(c * a.r - s * a.theta) / R, (s * a.r + c * a.theta) / R};
  }
}

void PolarAverage::evaluate(const ResponseAtTime& response, double t, std::span<double> b_x, std::span<double> b_y,
                            const InPieces& pieces) {
  const AmplitudeValue g = motion_->polar()->turn().at(t);
  response.plane_tau(xi_, tau_, pieces);
  pieces(xi_.size(), [&](std::size_t begin, std::size_t end) {
    rotate(g.value, rest_, h_.data(), tau_.data(), xi_.size(), begin, end, rotated_.data());
  });
  pieces(edges_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      flux_[e] = flux_of(std::span(points_).subspan(edges_[e].begin, edges_[e].end - edges_[e].begin), rotated_);
    }
  });
  split_at_fronts(response, g.value);
  accelerations(t);
  pieces(shapes_.size(), [&](std::size_t begin, std::size_t end) {
    moments_.integrals(node_a_, begin, end, force_);
    for (std::size_t k = begin; k < end; ++k) force_on(k);
  });
  pieces(places_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      const Point b = places_[p].turned(force_[places_[p].shape]);
      b_x[p] = b[0], b_y[p] = b[1];
    }
  });
}

/// From the integral of a over the shape.
void PolarAverage::force_on(std::size_t k) {
  const Shape& shape = shapes_[k];
  Point flux{};
  for (std::uint32_t i = shape.sides_begin; i < shape.sides_end; ++i) {
    const Point& f = flux_[sides_[i].edge];
    flux[0] += sides_[i].sign * f[0];
    flux[1] += sides_[i].sign * f[1];
  }
  for (std::size_t d = 0; d < 2; ++d) force_[k][d] = shape.of_inertia * force_[k][d] + shape.of_flux * flux[d];
}

PolarMeans::PolarMeans(const Motion& motion, const ReferenceDomains& domains)
    : places_(domains.places), moments_(motion->polar()->ring(), domains), nodes_(motion, moments_.nodes()) {
  for (const auto& shape : domains.shapes) volume_.push_back(shape.volume);
  node_x_.resize(nodes_.size()), node_v_.resize(nodes_.size());
  added_x_.resize(volume_.size()), added_v_.resize(volume_.size());
}

void PolarMeans::set_time(double t) {
  nodes_.set_time(t);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const RingKinematics ring = nodes_[k];
    const double R = nodes_.radius(k), c = std::cos(ring.alpha), s = std::sin(ring.alpha), stretch = ring.rho / R;
    const double along = ring.rho_rate / R, across = stretch * ring.alpha_rate;
    node_x_[k] = {c * stretch - 1, s * stretch};
    node_v_[k] = {c * along - s * across, s * along + c * across};
  }
  moments_.integrals(node_x_, 0, volume_.size(), added_x_);
  moments_.integrals(node_v_, 0, volume_.size(), added_v_);
}

PlaneMean PolarMeans::at(std::size_t p, const Point& centroid) const {
  const ReferenceDomains::Place& place = places_[p];
  const Point x = place.turned(added_x_[place.shape]), v = place.turned(added_v_[place.shape]);
  const double volume = volume_[place.shape];
  return {{centroid[0] + x[0] / volume, centroid[1] + x[1] / volume}, {v[0] / volume, v[1] / volume}};
}

}  // namespace assay
