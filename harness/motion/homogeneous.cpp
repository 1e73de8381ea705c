// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/homogeneous.hpp"

#include <algorithm>

#include "harness/motion/path_recipe.hpp"

namespace assay {

namespace {

bool is_uniaxial_strain(const Tensor& final) {
  Tensor rest = final;
  rest(0, 0) = 1;
  return rest == Tensor::Identity() && final(0, 0) != 1;
}

}  // namespace

ExactState Homogeneous::at(const Vector3& X, double t) const {
  const Tensor rate = (final - Tensor::Identity()) / period;
  ExactState state;
  state.F = Tensor::Identity() + t * rate;
  state.x = state.F * X;  // (37)
  state.v = rate * X;
  state.F_rate = rate;
  return state;
}

double Homogeneous::own_parameter() const { return is_uniaxial_strain(final) ? final(0, 0) - 1 : 1; }

Path Homogeneous::baseline() const {
  Path path;
  const double own = own_parameter();
  path.name = is_uniaxial_strain(final) ? "uniaxial_strain" : "straight";
  path.direction = (final - Tensor::Identity()) / own;
  path.amplitude = [T = period](double t) { return t / T; };
  path.amplitude_rate = [T = period](double) { return 1 / T; };
  path.parameter = {std::min(0.0, own), std::max(0.0, own)};
  path.reversals = [](double) { return std::vector<double>(); };
  path.amplitude_range = [T = period](double end) { return Interval{0, end / T}; };
  path.recipe = recipe_of(*this);
  return path;
}

}  // namespace assay
