// SPDX-License-Identifier: BSD-3-Clause
// A material with one direction, which the host fills in.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "harness/material/material.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay {

/// A fibre in a neo-Hookean matrix.
struct Fibre {
  static constexpr std::size_t state_size = 3;
  explicit Fibre(const double*) {}

  static Tensor kirchhoff(const Tensor& F, const Vector3& direction) {
    constexpr double mu = 400, lambda = 600, stiffness = 500;
    const Vector3 a = F * direction;
    return (lambda * std::log(F.determinant()) - mu) * Tensor::Identity() + mu * F * F.transpose() +
           stiffness * (a.squaredNorm() - 1) * a * a.transpose();
  }

  static std::optional<Tensor> take(const check_tests::PointStep& at, const double* before, double* after) {
    std::copy_n(before, state_size, after);
    return kirchhoff(at.F1, Vector3(before[0], before[1], before[2])) / at.F1.determinant();
  }
  static bool rest(const Tensor& cauchy, double* state) {
    std::fill_n(state, state_size, 0.0);
    return cauchy.isZero(0);
  }
  void misbehave(std::size_t, double*, double*) const {}
};

inline std::shared_ptr<const Material> fibre_material() {
  static const assay_state_variable state[] = {{"fibre", "1", ASSAY_VECTOR, ASSAY_ROLE_DIRECTION, "direction"}};
  static const assay_material table = [] {
    assay_material t = check_tests::table_of<Fibre>("fibre_for_tests", 0, std::span<const assay_parameter>(), state);
    t.symmetry = ASSAY_ANISOTROPIC;
    return t;
  }();
  return std::make_shared<const Material>(&table, std::map<std::string, double>());
}

}  // namespace assay
