// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/rigid.hpp"

#include <Eigen/Geometry>

#include "harness/motion/path_recipe.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay {

namespace {

/// W v = n x v.
Tensor cross_product(const Vector3& n) {
  Tensor W;
  W << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return W;
}

}  // namespace

ExactState Rigid::at(const Vector3& X, double t) const {
  const Vector3 n = unit_along(axis);
  const Tensor W = spin * cross_product(n);
  ExactState state;
  state.F = Eigen::AngleAxisd(spin * t, n).toRotationMatrix();
  state.F_rate = W * state.F;
  state.x = state.F * X + t * velocity;
  state.v = state.F_rate * X + velocity;
  state.a = W * (state.F_rate * X);
  return state;
}

Path Rigid::baseline() const {
  Path path;
  path.name = "rigid";
  path.parameter = {0, 1};
  path.curved = [m = *this](double, double t) {
    const ExactState state = m.at(Vector3::Zero(), t);
    return PathPoint{state.F, state.F_rate};
  };
  path.reversals = [](double) { return std::vector<double>(); };
  path.recipe = recipe_of(*this);
  return path;
}

}  // namespace assay
