// SPDX-License-Identifier: BSD-3-Clause
// Integrals of X f(R) over the part in the ring of each of many reference domains, for any function f of the radius.
#include "harness/exact/polar_average.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/numeric/gauss.hpp"
#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

constexpr int panel_nodes = 7;    ///< of the interpolation in R
constexpr int fewest_panels = 8;  ///< across the ring
/// Wider panels than the domains: fewer of them for each shape. The next term of f is then still rounding.
constexpr double domains_a_panel = 4;

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

/// f is interpolated between radial nodes that all shapes share, in panels.
int RingMoments::lay_out_panels(const Annulus& ring, const ReferenceDomains& domains) {
  const double ri = ring.inner, width = ring.outer - ring.inner;
  double largest_volume = 0;
  for (const auto& shape : domains.shapes) largest_volume = std::max(largest_volume, shape.volume);
  double panel = width / fewest_panels;
  if (largest_volume > 0) panel = std::min(panel, domains_a_panel * std::sqrt(largest_volume));
  const int panels = static_cast<int>(std::ceil(width / panel - 1e-9));
  for (int k = 0; k < panels; ++k) {
    for (const GaussPoint& node : gauss_rule<panel_nodes>()) {
      nodes_.push_back(ri + width * (k + 0.5 * (1 + node.at)) / panels);
    }
  }
  return panels;
}

/// The integral of X times each node's polynomial, over every shape.
RingMoments::RingMoments(const Annulus& ring, const ReferenceDomains& domains) {
  const int panels = lay_out_panels(ring, domains);
  const double ri = ring.inner, scale = panels / (ring.outer - ring.inner);
  std::vector<Point> sums(nodes_.size(), Point{});
  for (const auto& shape : domains.shapes) {
    std::size_t low = sums.size(), high = 0;
    for_each_area_point(shape.boundary, [&](const Point& X, double w) {
      const double at = (std::hypot(X[0], X[1]) - ri) * scale;
      const int panel = std::clamp(static_cast<int>(at), 0, panels - 1);
      const auto value = lagrange(2 * (at - panel) - 1);
      const auto first = static_cast<std::size_t>(panel * panel_nodes);
      low = std::min(low, first), high = std::max(high, first + panel_nodes);
      for (std::size_t i = 0; i < panel_nodes; ++i) {
        for (std::size_t d = 0; d < 2; ++d) sums[first + i][d] += w * value[i] * X[d];
      }
    });
    Range range;
    range.begin = static_cast<std::uint32_t>(weights_.size());
    range.node = static_cast<std::uint32_t>(std::min(low, high));
    for (std::size_t i = low; i < high; ++i) weights_.push_back(std::exchange(sums[i], Point{}));
    range.end = static_cast<std::uint32_t>(weights_.size());
    ranges_.push_back(range);
  }
}

/// Both parts of f at once, along x and y: four numbers.
ASSAY_VECTOR_CLONES void RingMoments::sum_up(std::span<const Range> ranges, const Point* weights, const Point* f,
                                             Point* out) {
  using Four = double __attribute__((vector_size(4 * sizeof(double))));
  for (const Range& range : ranges) {
    const Point* a = f + range.node;
    Four sum{};
    for (std::uint32_t i = range.begin; i < range.end; ++i, ++a) {
      const Point& w = weights[i];
      const Four part{(*a)[0], (*a)[0], (*a)[1], (*a)[1]}, of_shape{w[0], w[1], w[0], w[1]};
      sum += part * of_shape;
    }
    *out++ = {sum[0] - sum[3], sum[1] + sum[2]};
  }
}

void RingMoments::integrals(std::span<const Point> f, std::size_t first, std::size_t last, std::span<Point> out) const {
  sum_up(std::span(ranges_).subspan(first, last - first), weights_.data(), f.data(), out.data() + first);
}

}  // namespace assay
