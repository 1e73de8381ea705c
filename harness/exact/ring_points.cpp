// SPDX-License-Identifier: BSD-3-Clause
// Fixed reference points of a ring, grouped by radius.
#include "harness/exact/polar.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

namespace {

/// Radii this close [relative] are one: what rounding makes of points on one circle.
constexpr double same_radius = 1e-14;

}  // namespace

RingPoints::RingPoints(std::span<const double> X, std::span<const double> Y) {
  std::vector<double> all(X.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::hypot(X[i], Y[i]);
  radius = all;
  std::sort(radius.begin(), radius.end());
  // unique compares with the first of each group: a group is never wider than the tolerance
  const auto same = [](double first, double next) { return next - first <= same_radius * first; };
  radius.erase(std::unique(radius.begin(), radius.end(), same), radius.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto next = std::upper_bound(radius.begin(), radius.end(), all[i]);  // its group began at or below it
    ring.push_back(static_cast<std::uint32_t>(next - radius.begin() - 1));
    cos_theta.push_back(all[i] > 0 ? X[i] / all[i] : 1);
    sin_theta.push_back(all[i] > 0 ? Y[i] / all[i] : 0);
  }
}

}  // namespace assay
