// SPDX-License-Identifier: BSD-3-Clause
// A family of baseline deformation histories F(xi, t): what the point driver takes a material through.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/tensor.hpp"

namespace assay {

struct Interval {
  double lower = 0, upper = 0;
  double width() const { return upper - lower; }
};

/// A straight family F = I + eps D with eps = xi g(t), and everything that is needed to tabulate it.
struct Path {
  std::string name;                                      ///< "simple_shear" (16), "uniaxial_strain" (38), "straight"
  Tensor direction = Tensor::Zero();                     ///< D [1]
  std::function<double(double)> amplitude;               ///< g(t) [1]
  Interval parameter;                                    ///< range of xi [1]
  std::function<std::vector<double>(double)> reversals;  ///< times in (0, end) at which g' changes its sign
  std::function<Interval(double)> amplitude_range;       ///< of g over 0 .. end, or wider [1]

  double eps(double xi, double t) const { return xi * amplitude(t); }
  Tensor deformation_gradient(double xi, double t) const { return Tensor::Identity() + eps(xi, t) * direction; }
};

/// Straight to every eps that the path reaches until `end`: amplitude t on 0 .. 1, parameter eps. What a
/// path-independent material knows of the path.
Path loading_path(const Path& path, double end);

}  // namespace assay
