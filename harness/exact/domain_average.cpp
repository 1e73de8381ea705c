// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/domain_average.hpp"

#include <algorithm>
#include <cmath>

#include "harness/numeric/sine_cosine.hpp"
#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

/// A front this close to an edge's end [relative to ro] is at its end.
constexpr double front_snap = 1e-12;

/// S = Q(g h) tau at radii first to last - 1 of n; tau[c * n + i].
ASSAY_VECTOR_CLONES void rotate(double g, const double* __restrict h, const double* __restrict tau, std::size_t n,
                                std::size_t first, std::size_t last, DomainAverage::Rotated* __restrict out) {
  const double *t11 = tau, *t12 = t11 + n, *t21 = t12 + n, *t22 = t21 + n;
  for (std::size_t i = first; i < last; ++i) {
    double c = 1, s = 0;
    sine_cosine(g * h[i], s, c);
    out[i].s11 = c * t11[i] - s * t21[i];
    out[i].s12 = c * t12[i] - s * t22[i];
    out[i].s21 = s * t11[i] + c * t21[i];
    out[i].s22 = s * t12[i] + c * t22[i];
  }
}

}  // namespace

/// Products with n1 stand beside those with n2 and are added up in the end.
Point DomainAverage::flux_of(std::span<const BoundaryPoint> points, std::span<const Rotated> S) const {
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
void DomainAverage::cuts_of(const Edge& edge, std::span<const double> radii, std::vector<double>& cuts) const {
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
void DomainAverage::split_at_fronts(const PlaneResponse& response, double t, double g) {
  std::vector<double> radii, radius, cuts;
  for (const double xi : response.fronts(t)) {
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
  const std::vector<Rotated> S = rotated_at(response, t, g, radius);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].radius = static_cast<std::uint32_t>(i);
  std::size_t begin = 0;
  for (const auto& [e, end] : split) {
    flux_[e] = flux_of(std::span(points).subspan(begin, end - begin), S);
    begin = end;
  }
}

std::vector<DomainAverage::Rotated> DomainAverage::rotated_at(const PlaneResponse& response, double t, double g,
                                                              std::span<const double> radius) const {
  const std::size_t n = radius.size();
  std::vector<double> xi(n), h(n), tau(4 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const RingParameter parameter = ring_parameter(motion_, radius[i]);
    xi[i] = parameter.value, h[i] = parameter.h;
  }
  response.tau(t, xi, tau);
  std::vector<Rotated> S(n);
  rotate(g, h.data(), tau.data(), n, 0, n, S.data());
  return S;
}

/// f of a = X f, (29) of the vortex, at the radial nodes.
void DomainAverage::accelerations(double t) {
  nodes_.set_time(t);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const RingKinematics ring = nodes_[k];
    const Polar a = ring.acceleration();
    const double c = std::cos(ring.alpha), s = std::sin(ring.alpha), R = nodes_.radius(k);
    node_a_[k] = {(c * a.r - s * a.theta) / R, (s * a.r + c * a.theta) / R};
  }
}

void DomainAverage::evaluate(const PlaneResponse& response, double t, std::span<double> b_x, std::span<double> b_y,
                             const InPieces& pieces) {
  const AmplitudeValue g = motion_->polar()->turn().at(t);
  response.tau(t, xi_, tau_);
  pieces(xi_.size(), [&](std::size_t begin, std::size_t end) {
    rotate(g.value, h_.data(), tau_.data(), xi_.size(), begin, end, rotated_.data());
  });
  pieces(edges_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      flux_[e] = flux_of(std::span(points_).subspan(edges_[e].begin, edges_[e].end - edges_[e].begin), rotated_);
    }
  });
  split_at_fronts(response, t, g.value);
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
void DomainAverage::force_on(std::size_t k) {
  const Shape& shape = shapes_[k];
  Point flux{};
  for (std::uint32_t i = shape.sides_begin; i < shape.sides_end; ++i) {
    const Point& f = flux_[sides_[i].edge];
    flux[0] += sides_[i].sign * f[0];
    flux[1] += sides_[i].sign * f[1];
  }
  for (std::size_t d = 0; d < 2; ++d) force_[k][d] = shape.of_inertia * force_[k][d] + shape.of_flux * flux[d];
}

void DomainAverage::evaluate(const Response& response, double t, std::span<double> b_x, std::span<double> b_y,
                             const InPieces& pieces) {
  evaluate({[&](double time, std::span<const double> xi, std::span<double> tau) {
              response.plane_tau_at_time(time, xi, tau, pieces);
            },
            [&](double time) { return response.fronts(time); }},
           t, b_x, b_y, pieces);
}

}  // namespace assay
