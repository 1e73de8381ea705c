// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/amplitude.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assay {

using std::numbers::pi;

AmplitudeValue Amplitude::at(double t) const {
  switch (type) {
    case Type::sine: {
      const double w = pi / period, phase = w * std::fmod(t, 2 * period);  // fmod is exact: late times lose nothing
      const double s = std::sin(phase), c = std::cos(phase);
      return {peak * s, peak * w * c, -peak * w * w * s};
    }
    case Type::one_minus_cosine: {
      const double w = 2 * pi / period, phase = w * std::fmod(t, period);
      const double half = std::sin(0.5 * phase);  // 1 - cos = 2 sin^2: no cancellation
      return {peak * half * half, 0.5 * peak * w * std::sin(phase), 0.5 * peak * w * w * std::cos(phase)};
    }
    case Type::ramp:
      if (t < period) return {peak * t / period, peak / period, 0};
      return {peak, 0, 0};
  }
  return {};
}

std::pair<double, double> Amplitude::range(double end) const {
  const bool both_signs = type == Type::sine && end > period;
  return std::minmax({both_signs ? -peak : 0.0, peak});
}

std::vector<double> Amplitude::reversals(double end) const {
  std::vector<double> times;
  if (type == Type::ramp) {
    if (period < end) times.push_back(period);
    return times;
  }
  // g' = 0 at (k + 1/2) T for the sine, at k T/2 for one minus cosine
  const double first = 0.5 * period, spacing = type == Type::sine ? period : 0.5 * period;
  return times_before(end, [&](double k) { return first + k * spacing; });
}

std::vector<double> times_before(double end, const std::function<double(double k)>& at) {
  std::vector<double> times;
  for (double k = 0; at(k) < end && at(k + 1) > at(k); ++k) times.push_back(at(k));
  return times;
}

}  // namespace assay
