// SPDX-License-Identifier: BSD-3-Clause
// A family of baseline deformation histories F(xi, t): what the point driver takes a material through.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "harness/numeric/range.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// Deformation gradient [1] and its rate [1/s].
struct PathPoint {
  Tensor F = Tensor::Identity();
  Tensor F_rate = Tensor::Zero();
};

/// A straight family F = I + eps D with eps = xi g(t), or one that is `curved`; with what is needed to tabulate it.
struct Path {
  std::string name;    ///< "simple_shear" (16), "uniaxial_strain" (38), "straight", "rotating_stretch", "table"
  Interval parameter;  ///< range of xi [1]
  /// xi says where in the body, not how much it is deformed: a part of the range is no weaker motion.
  bool parameter_is_place = false;
  std::function<std::vector<double>(double)> reversals;  ///< times in (0, end) at which g' changes its sign

  Tensor direction = Tensor::Zero();                ///< D [1]
  std::function<double(double)> amplitude;          ///< g(t) [1]
  std::function<double(double)> amplitude_rate;     ///< g'(t) [1/s]
  std::function<Interval(double)> amplitude_range;  ///< of g over 0 .. end, or wider [1]

  std::function<PathPoint(double xi, double t)> curved;  ///< set instead of the four above

  /// Components along the baseline frame E1, E2, E3 of the direction that a material with one has at rest [1].
  std::array<double, 3> material_direction{1, 0, 0};
  /// Cauchy stress at rest, components along that frame; it is the same everywhere in the body [Pa].
  Tensor initial_cauchy = Tensor::Zero();

  /// Numbers of which another process makes this path, but for `parameter`, `material_direction`
  /// and `initial_cauchy`: registry.hpp.
  /// Empty of a path that no motion has made.
  std::vector<double> recipe;

  bool straight() const { return !curved; }
  double eps(double xi, double t) const { return xi * amplitude(t); }  ///< of a straight family
  PathPoint at(double xi, double t) const;
  Tensor deformation_gradient(double xi, double t) const { return at(xi, t).F; }
};

/// Straight to every eps that a straight path reaches until `end`: amplitude t on 0 .. 1, parameter eps. What a
/// path-independent material knows of the path.
Path loading_path(const Path& path, double end);

}  // namespace assay
