// SPDX-License-Identifier: BSD-3-Clause
// A law that is right in frames of small rotations and wrong in those of large ones.
#include <gtest/gtest.h>

#include "harness/check/battery.hpp"
#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_large_turns {
namespace {

using check_tests::PointStep;

/// Neo-Hookean elasticity (34), stiffer where tr F is below a limit: beyond some angle of a rotation.
struct Law {
  static constexpr std::size_t state_size = 0;
  double limit;

  explicit Law(const double* p) : limit(p[0]) {}
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    constexpr double mu = 400, lambda = 600, stiffer = 1.2;
    const double J = step.F1.determinant();
    if (!(J > 0)) return std::nullopt;
    const Tensor I = Tensor::Identity(), b = step.F1 * step.F1.transpose();
    return (step.F1.trace() < limit ? stiffer : 1) * Tensor((lambda * std::log(J) * I + mu * (b - I)) / J);
  }
};

class LargeTurns : public testing::TestWithParam<double> {};

TEST_P(LargeTurns, AreNamedAsWhatTheyAre) {
  static const assay_parameter parameters[] = {{"limit", "1", -10, -10, 10, ""}};
  static const assay_material table = check_tests::table_of<Law>("large_turns_for_tests", 0, parameters, {});
  const Report right = run_battery(Material(&table, {}), {.effort = {.quick = true}});
  EXPECT_TRUE(right.passes());
  const Report report = run_battery(Material(&table, {{"limit", GetParam()}}), {.effort = {.quick = true}});
  ASSERT_FALSE(report.diagnosis.empty());
  EXPECT_EQ(report.diagnosis.front().cause, causes::not_indifferent) << report.diagnosis.front().sentence;
}

/// Of tr F: at angles of 90 degrees, and more and more up to 139.
INSTANTIATE_TEST_SUITE_P(Limits, LargeTurns, testing::Values(0.9, 0.0, -0.3, -0.4, -0.5, -0.8));

}  // namespace
}  // namespace assay::check::test_large_turns
