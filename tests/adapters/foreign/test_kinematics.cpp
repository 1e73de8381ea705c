// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/kinematics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace assay::adapters::test_kinematics {
namespace {

constexpr double rounding = 1e-13;

Tensor turn(double angle) { return Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).toRotationMatrix(); }

Tensor gradient(double s) {
  Tensor F;
  F << 1 + 0.3 * s, 0.4 * s, -0.1 * s, 0.2 * s * s, 1 - 0.2 * s, 0.3 * s, 0.1 * s, -0.3 * s, 1 + 0.1 * s;
  return F;
}

TEST(StepStrain, IsThePolarDecompositionOfTheStep) {
  const Tensor F0 = gradient(0.3), F1 = turn(1.1) * gradient(1);
  const StepStrain step = step_strain(F0, F1, Kinematics::objective);
  EXPECT_LT((step.rotation.transpose() * step.rotation - Tensor::Identity()).norm(), rounding);
  EXPECT_LT((Tensor(step.strain.exp()) * step.rotation - F1 * F0.inverse()).norm(), 10 * rounding);
}

TEST(StepStrain, ATurnOfTheBodyIsARotationAlone) {
  const Tensor F0 = gradient(0.7), Q = turn(0.9);
  const StepStrain step = step_strain(F0, Q * F0, Kinematics::objective);
  EXPECT_LT(step.strain.norm(), rounding);
  EXPECT_LT((step.rotation - Q).norm(), rounding);
}

TEST(StepStrain, OfHughesAndWingetIsTheirFormula) {
  const Tensor F0 = gradient(0.5), F1 = gradient(0.6), l = (F1 - F0) * (0.5 * (F0 + F1)).inverse();
  const Tensor w = 0.5 * (l - l.transpose()), I = Tensor::Identity();
  const StepStrain step = step_strain(F0, F1, Kinematics::abaqus);
  EXPECT_LT((step.strain - 0.5 * (l + l.transpose())).norm(), rounding);
  EXPECT_LT((step.rotation - (I - 0.5 * w).inverse() * (I + 0.5 * w)).norm(), rounding);
}

/// Sum of the strains of n steps of a body that turns while it is stretched.
Tensor corotational_sum(int n, double turned, Kinematics kinematics) {
  Tensor sum = Tensor::Zero();
  const auto F = [&](int k) { return Tensor(turn(turned * k / n) * gradient(static_cast<double>(k) / n)); };
  for (int k = 0; k < n; ++k) sum += corotational_step(F(k), F(k + 1), kinematics).strain;
  return sum;
}

TEST(CorotationalStep, SeesNoTurnOfTheBodyAndIsOfSecondOrder) {
  for (const Kinematics kinematics : {Kinematics::objective, Kinematics::abaqus}) {
    EXPECT_LT((corotational_sum(10, 3, kinematics) - corotational_sum(10, 0, kinematics)).norm(), 10 * rounding);
    const Tensor exact = corotational_sum(2000, 0, kinematics);
    const double coarse = (corotational_sum(10, 0, kinematics) - exact).norm(),
                 fine = (corotational_sum(20, 0, kinematics) - exact).norm();
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  }
}

TEST(CorotationalStep, OfStretchesAlongFixedAxesIsExact) {
  const Tensor F0 = Vector3(1.1, 0.9, 1.3).asDiagonal(), F1 = Vector3(1.5, 0.7, 1).asDiagonal();
  const Tensor found = corotational_step(F0, turn(0.4) * F1, Kinematics::objective).strain;
  const Tensor expected = Vector3(std::log(1.5 / 1.1), std::log(0.7 / 0.9), std::log(1 / 1.3)).asDiagonal();
  EXPECT_LT((found - expected).norm(), rounding);
}

TEST(Rates, AreThoseOfDifferences) {
  constexpr double h = 1e-6, of_differences = 1e-9;
  const Tensor F0 = gradient(0.4), F1 = turn(0.2) * gradient(0.6);
  Tensor E = Tensor::Zero();
  E(0, 2) = 1;
  const StepStrain a = logarithmic_strain_of(F1 + h * E), b = logarithmic_strain_of(F1 - h * E);
  const StepStrain rate = rate_of_logarithmic_strain(F1, E);
  EXPECT_LT((rate.strain - (a.strain - b.strain) / (2 * h)).norm(), of_differences);
  EXPECT_LT((rate.rotation - (a.rotation - b.rotation) / (2 * h)).norm(), of_differences);
  const auto at = [&](double by) {
    StepStrain s = step_strain(F0, F1 + by * E, Kinematics::objective);
    s.strain = s.rotation.transpose() * s.strain * s.rotation;
    return s;
  };
  const StepStrain found = rate_of_step(F0, F1, E, Kinematics::objective);
  EXPECT_LT((found.strain - (at(h).strain - at(-h).strain) / (2 * h)).norm(), of_differences);
  EXPECT_LT((found.rotation - (at(h).rotation - at(-h).rotation) / (2 * h)).norm(), of_differences);
}

}  // namespace
}  // namespace assay::adapters::test_kinematics
