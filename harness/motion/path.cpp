// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/path.hpp"

#include <algorithm>

namespace assay {

PathPoint Path::at(double xi, double t) const {
  if (curved) return curved(xi, t);
  return {Tensor::Identity() + eps(xi, t) * direction, xi * amplitude_rate(t) * direction};
}

Path loading_path(const Path& path, double end) {
  const Interval g = path.amplitude_range(end), xi = path.parameter;
  const auto reached = {xi.lower * g.lower, xi.lower * g.upper, xi.upper * g.lower, xi.upper * g.upper};
  Path straight;
  straight.name = path.name;
  straight.direction = path.direction;
  straight.material_direction = path.material_direction;
  straight.initial_cauchy = path.initial_cauchy;
  straight.amplitude = [](double t) { return t; };
  straight.amplitude_rate = [](double) { return 1.0; };
  straight.parameter = {std::min(reached), std::max(reached)};
  straight.reversals = [](double) { return std::vector<double>(); };
  straight.amplitude_range = [](double last) { return Interval{0, last}; };
  return straight;
}

}  // namespace assay
