// SPDX-License-Identifier: BSD-3-Clause
#include "harness/ring_points.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

RingPoints::RingPoints(std::span<const double> X, std::span<const double> Y) {
  std::vector<double> all(X.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::hypot(X[i], Y[i]);
  radius = all;
  std::sort(radius.begin(), radius.end());
  radius.erase(std::unique(radius.begin(), radius.end()), radius.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    ring.push_back(static_cast<std::uint32_t>(std::lower_bound(radius.begin(), radius.end(), all[i]) - radius.begin()));
    cos_theta.push_back(all[i] > 0 ? X[i] / all[i] : 1);
    sin_theta.push_back(all[i] > 0 ? Y[i] / all[i] : 0);
  }
}

}  // namespace assay
