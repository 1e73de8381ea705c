// SPDX-License-Identifier: BSD-3-Clause
#include "harness/ring_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/gauss.hpp"

namespace assay {

namespace {

constexpr int panel_nodes = 7;    ///< of the interpolation in R
constexpr int fewest_panels = 8;  ///< across the ring

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

/// f is interpolated between radial nodes that all shapes share, in panels no wider than a whole domain.
int RingMoments::lay_out_panels(const Vortex& vortex, const ReferenceDomains& domains) {
  const double ri = vortex.inner, width = vortex.outer - vortex.inner;
  double largest_volume = 0;
  for (const auto& shape : domains.shapes) largest_volume = std::max(largest_volume, shape.volume);
  double panel = width / fewest_panels;
  if (largest_volume > 0) panel = std::min(panel, std::sqrt(largest_volume));
  const int panels = static_cast<int>(std::ceil(width / panel - 1e-9));
  for (int k = 0; k < panels; ++k) {
    for (const GaussPoint& node : gauss_rule<panel_nodes>()) {
      node_h_.push_back(vortex.profile(ri + width * (k + 0.5 * (1 + node.at)) / panels).h);
    }
  }
  return panels;
}

/// The integral of X times each node's polynomial, over every shape.
RingMoments::RingMoments(const Vortex& vortex, const ReferenceDomains& domains) {
  const int panels = lay_out_panels(vortex, domains);
  const double ri = vortex.inner, scale = panels / (vortex.outer - vortex.inner);
  std::vector<Point> sums(node_h_.size(), Point{});
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

Point RingMoments::integral(std::size_t shape, std::span<const Point> f) const {
  const Range& range = ranges_[shape];
  const Point* a = f.data() + range.node;
  double along_x = 0, along_y = 0, across_x = 0, across_y = 0;
  for (std::uint32_t i = range.begin; i < range.end; ++i, ++a) {
    const Point& w = weights_[i];
    along_x += (*a)[0] * w[0], along_y += (*a)[0] * w[1];
    across_x += (*a)[1] * w[0], across_y += (*a)[1] * w[1];
  }
  return {along_x - across_y, along_y + across_x};
}

}  // namespace assay
