// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/foreign_table.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

#include "adapters/builtin.hpp"
#include "adapters/library.hpp"
#include "harness/check/battery.hpp"
#include "harness/material/material.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_foreign_table {
namespace {

/// det F from 1/2 to 2 and rotations of any angle.
Tensor random_gradient(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-0.4, 0.4);
  for (;;) {
    Tensor F = Tensor::Identity();
    for (int c = 0; c < 9; ++c) component(F, c) += uniform(random);
    const double angle = 10 * uniform(random);
    if (F.determinant() > 0.3) return Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()) * F;
  }
}

std::vector<double> stress_of(const Material& material, const Tensor& F0, const Tensor& F1) {
  double begin[9], end[9];
  for (int c = 0; c < 9; ++c) begin[c] = component(F0, c), end[c] = component(F1, c);
  const std::vector<double> state0 = material.initial_state(1);
  std::vector<double> state1(state0.size()), cauchy(9);
  const UpdateReport report = material.update(0, 0.1, 1, begin, end, state0.data(), state1.data(), cauchy.data());
  EXPECT_EQ(report.worst, ASSAY_GOOD) << report.message;
  return cauchy;
}

class ForeignNeoHookean : public testing::TestWithParam<const char*> {};

TEST_P(ForeignNeoHookean, AgreesWithTheNativeOne) {
  constexpr double rounding = 1e-12;  // of the largest component; a polar decomposition stands between
  if (!double_exists(GetParam())) GTEST_SKIP() << "no Fortran compiler";
  const Material foreign(foreign_table(foreign_double(GetParam())), {});
  const Material native(builtin_table("neo_hookean"), {{"E", 1e3}, {"nu", 0.3}});
  std::mt19937 random(7);
  for (int k = 0; k < 100; ++k) {
    const Tensor F0 = random_gradient(random), F1 = random_gradient(random);
    const std::vector<double> found = stress_of(foreign, F0, F1), expected = stress_of(native, F0, F1);
    double largest = 0;
    for (const double s : expected) largest = std::max(largest, std::abs(s));
    for (std::size_t c = 0; c < 9; ++c) EXPECT_NEAR(found[c], expected[c], rounding * largest) << c;
  }
}

INSTANTIATE_TEST_SUITE_P(Doubles, ForeignNeoHookean,
                         testing::Values("umat_neo_hookean", "vumat_neo_hookean", "mfront_neo_hookean",
                                         "mfront_neo_hookean_specialised"),
                         [](const auto& instance) { return std::string(instance.param); });

class GoodForeignModel : public testing::TestWithParam<const char*> {};

TEST_P(GoodForeignModel, PassesTheBattery) {
  if (!double_exists(GetParam())) GTEST_SKIP() << "no Fortran compiler";
  ForeignModel model = foreign_double(GetParam());
  if (std::string(GetParam()) == "mfront_norton") model.flags = ASSAY_RATE_DEPENDENT;
  const Material material(foreign_table(model), {});
  const check::Report report = check::run_battery(material, {});
  for (const check::TestResult& test : report.tests) {
    EXPECT_NE(test.verdict, check::Verdict::fail) << test.id << ": " << test.cause << ": " << test.sentence;
  }
}

INSTANTIATE_TEST_SUITE_P(Doubles, GoodForeignModel,
                         testing::Values("umat_neo_hookean", "vumat_neo_hookean", "mfront_neo_hookean", "umat_j2",
                                         "vumat_j2", "mfront_norton"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace assay::adapters::test_foreign_table
