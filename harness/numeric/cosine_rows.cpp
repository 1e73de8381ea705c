// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/cosine_rows.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace assay {

namespace {

/// sin(x)/x.
double sinc(double x) { return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x; }

}  // namespace

CosineRows::CosineRows(int modes, std::span<const Interval> stretches) : modes_(static_cast<std::size_t>(modes)) {
  using std::numbers::pi;
  std::map<std::pair<double, double>, std::uint32_t> known;
  for (const Interval& stretch : stretches) {
    const auto [it, is_new] =
        known.try_emplace({stretch.lower, stretch.upper}, static_cast<std::uint32_t>(mean_sine_.size()));
    row_.push_back(it->second);
    if (!is_new) continue;
    const double middle = 0.5 * (stretch.lower + stretch.upper), half = 0.5 * pi * stretch.width();
    for (int k = 0; k < modes; ++k) {  // the mean of exp(i k pi X) is that of its middle times sinc
      mean_.push_back(std::cos(k * pi * middle) * sinc(k * half));
      slope_.push_back(-k * pi * std::sin(k * pi * middle) * sinc(k * half));
    }
    mean_sine_.push_back(std::sin(pi * middle) * sinc(half));
  }
}

}  // namespace assay
