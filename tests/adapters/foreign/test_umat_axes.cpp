// SPDX-License-Identifier: BSD-3-Clause
// UMATs in axes that turn with the body, as with Abaqus' *ORIENTATION.
#include <Eigen/Geometry>

#include "tests/adapters/foreign/foreign_steps.hpp"

namespace assay::adapters::test_umat_axes {
namespace {

Tensor turn(double angle) { return Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).toRotationMatrix(); }

Tensor gradient(double s) {
  Tensor F;
  F << 1 + 0.3 * s, 0.4 * s, -0.1 * s, 0.2 * s * s, 1 - 0.2 * s, 0.3 * s, 0.1 * s, -0.3 * s, 1 + 0.1 * s;
  return F;
}

/// Stress after ten steps of a body that turns about while it is stretched.
Tensor stress_of(ForeignModel model, double turned) {
  StepsOfOnePoint point(model);
  constexpr int steps = 10;
  Tensor before = Tensor::Identity(), stress;
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps;
    const Tensor after = turn(turned * s) * gradient(s);
    stress = point.taken(s, 0.1, before, after).cauchy;
    before = after;
  }
  return stress;
}

TEST(CorotationalAxes, MakeAnOrthotropicUmatIndifferentToTheFrame) {
  constexpr double rounding = 1e-12, large = 1e-2, angle = 2;
  ForeignModel model = foreign_double("umat_orthotropic");
  const auto error = [&] {
    const Tensor still = stress_of(model, 0), turned = stress_of(model, angle);
    return (turn(angle) * still * turn(angle).transpose() - turned).norm() / still.norm();
  };
  EXPECT_LT(error(), rounding);
  model.kinematics = Kinematics::abaqus;
  EXPECT_LT(error(), rounding);
  model.axes = Axes::fixed;
  EXPECT_GT(error(), large) << "its moduli stay where they were";
}

TEST(CorotationalAxes, DeclareStateThatRotatesItself) {
  ForeignModel model = foreign_double("umat_orthotropic");
  const auto role = [](const ForeignModel& of) { return foreign_table(of)->state[0].role; };
  EXPECT_EQ(role(model), ASSAY_ROLE_ROTATES_ITSELF);
  model.axes = Axes::fixed;
  EXPECT_EQ(role(model), ASSAY_ROLE_PLAIN);
}

/// Largest error of the tangent of a step from a loaded and turned state, of its largest component.
double tangent_error(const ForeignModel& model) {
  constexpr double h = 1e-6;
  StepsOfOnePoint point(model);
  const Tensor F0 = turn(0.7) * gradient(0.5), F1 = turn(1.1) * gradient(0.8);
  point.taken(0, 0.1, Tensor::Identity(), F0);
  const std::vector<double> found = point.tangent(0.1, 0.1, F0, F1);
  double worst = 0, largest = 0;
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero();
    component(E, column) = h;
    const Tensor slope =
        (point.tried(0.1, 0.1, F0, F1 + E).cauchy - point.tried(0.1, 0.1, F0, F1 - E).cauchy) / (2 * h);
    for (int row = 0; row < 9; ++row) {
      const double expected = component(slope, row);
      worst = std::max(worst, std::abs(found[static_cast<std::size_t>(9 * row + column)] - expected));
      largest = std::max(largest, std::abs(expected));
    }
  }
  return worst / largest;
}

class TangentOfAUmat : public testing::TestWithParam<std::tuple<const char*, Axes, Kinematics>> {};

TEST_P(TangentOfAUmat, IsThatOfDifferences) {
  constexpr double of_differences = 1e-8;  // h^2 and rounding over h
  const auto [name, axes, kinematics] = GetParam();
  if (!double_exists(name)) GTEST_SKIP() << "no Fortran compiler";
  ForeignModel model = foreign_double(name);
  model.axes = axes;
  model.kinematics = kinematics;
  EXPECT_LT(tangent_error(model), of_differences);
}

constexpr auto any_kinematics = {Kinematics::objective, Kinematics::abaqus};
INSTANTIATE_TEST_SUITE_P(Orthotropic, TangentOfAUmat,
                         testing::Combine(testing::Values("umat_orthotropic"), testing::Values(Axes::corotational),
                                          testing::ValuesIn(any_kinematics)));
INSTANTIATE_TEST_SUITE_P(OfFiniteStrain, TangentOfAUmat,
                         testing::Combine(testing::Values("umat_neo_hookean"),
                                          testing::Values(Axes::fixed, Axes::corotational),
                                          testing::ValuesIn(any_kinematics)));

}  // namespace
}  // namespace assay::adapters::test_umat_axes
