// SPDX-License-Identifier: BSD-3-Clause
// The hardening of the J2 models, typed again for their tests, and their parameters.
#pragma once

#include <gtest/gtest.h>

#include "tests/adapters/models/histories.hpp"

namespace assay::model_tests {

struct Hardening {
  double yield = 20, linear = 0, saturation = 0, rate = 0, kinematic = 0, E = 1000, nu = 0.3;
  double radius(double p) const {
    return std::sqrt(2.0 / 3) * (yield + linear * p + saturation * (1 - std::exp(-rate * p)));
  }
  double slope(double p) const { return 2.0 / 3 * (linear + saturation * rate * std::exp(-rate * p)); }
  Parameters parameters() const {
    return {{"E", E},
            {"nu", nu},
            {"yield_stress", yield},
            {"hardening_modulus", linear},
            {"saturation_stress", saturation},
            {"saturation_rate", rate},
            {"kinematic_modulus", kinematic}};
  }
};

/// Stress at F = I is the initial one; beyond yield is refused, and pressure is not yield.
inline void expect_initial_stress(const std::string& model) {
  const Material material = material_of(model, Hardening{}.parameters());
  Tensor sigma;
  sigma << -300, 4, -3, 4, -305, 2, -3, 2, -298;
  double components[9];
  nine(sigma, components);
  const auto state = material.initial_state(1, components);
  const Tensor found = point_after(material, 0, 1, Tensor::Identity(), Tensor::Identity(), state).cauchy;
  EXPECT_LT(difference(found, sigma), 1e-11 * 300) << model;
  components[1] = components[3] = 12;
  EXPECT_THROW(material.initial_state(1, components), std::runtime_error) << model;
}

/// Shear of 7 in steps 10^4 times the yield strain: on the yield surface at each, and the error falls from the first.
inline void expect_long_steps(const std::string& model) {
  const Hardening h{20, 30, 0, 0, 0};
  Parameters stiff = h.parameters();
  stiff["E"] = 1e6;
  const Material material = material_of(model, stiff);
  const auto F = [](double t) {
    return Tensor(Tensor::Identity() + 7 * t * Eigen::Vector3d::UnitY() * Eigen::RowVector3d::UnitX());
  };
  const double fine = marched(material, F, 1, 4096).cauchy(0, 1);
  double before = fine;
  for (const int steps : {2, 4, 8, 16, 32, 64}) {
    const Point end = marched(material, F, 1, steps);
    const Tensor shape = end.cauchy - end.cauchy.trace() / 3 * Tensor::Identity();
    EXPECT_NEAR(shape.norm(), h.radius(end.state[0]), 1e-6) << model << " " << steps;
    const double error = std::abs(end.cauchy(0, 1) - fine);
    EXPECT_LT(error, 0.75 * before) << model << " " << steps;
    before = error;
  }
}

/// Yield points and reversals fall inside steps, at another place in each level: the mean order over five halvings.
/// exact(hardening, history): stress and p by the rate equations.
template <class Exact>
void expect_second_order(const std::string& model, const Hardening& h, const History& history, const Exact& exact,
                         double finest) {
  const Material material = material_of(model, h.parameters());
  const auto end = exact(h, history);
  ASSERT_GT(end.p, 0.1);
  const auto errors = errors_under_refinement(material, history, end.stress, 100, 6);
  EXPECT_GT(order_of(errors), 1.8);
  EXPECT_LT(errors.back(), finest);
  EXPECT_NEAR(marched(material, history.F, history.end, 3200).state[0], end.p, finest);
}

/// Each of five parameters, off by some per cent in the reference, leaves an error of more than `least`.
template <class Exact>
void expect_other_hardening_caught(const std::string& model, const History& history, const Exact& exact, double least) {
  const Material material = material_of(model, Hardening{20, 30, 15, 12, 80}.parameters());
  for (const Hardening& other :
       {Hardening{20.1, 30, 15, 12, 80}, Hardening{20, 30.3, 15, 12, 80}, Hardening{20, 30, 15.2, 12, 80},
        Hardening{20, 30, 15, 6, 80}, Hardening{20, 30, 15, 12, 81}}) {
    const auto errors = errors_under_refinement(material, history, exact(other, history).stress, 400, 3);
    EXPECT_GT(errors.back(), least);
    EXPECT_LT(order_of(errors), 0.5);
  }
}

}  // namespace assay::model_tests
