// SPDX-License-Identifier: BSD-3-Clause
// The sheet of every model against an independent integration of its equations, through loading, unloading and
// reversal.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/adapters/models/sheet_checks.hpp"

namespace assay::model_tests::test_sheets {
namespace {

/// What the integrations themselves leave, relative.
constexpr double reference_error = 2e-9;
constexpr double honest = 3;             ///< measured over stated error
constexpr double kinked_at_most = 1e-6;  ///< stated error of a model with kinks

void expect_agreement(const ModelCase& c, Amplitude::Type type, int points) {
  const Setting setting = setting_of(c, type);
  const Sheet sheet = sheet_of(c, setting);
  const SheetDifference d = sheet_difference(c, setting, sheet, points);
  std::printf("%-28s end %g: tau %.1e (stated %.1e)  dtau %.1e (stated %.1e)  %lld nodes\n", c.name.c_str(),
              setting.end, d.tau, sheet.error_tau(), d.dtau, sheet.error_dtau(),
              static_cast<long long>(sheet.points()));
  std::fflush(stdout);
  const double allowed = c.smooth() ? sheet_tolerance : kinked_at_most;
  EXPECT_LT(d.tau, allowed);
  EXPECT_LT(d.dtau, allowed);
  EXPECT_LT(d.tau, honest * sheet.error_tau() + reference_error);
  EXPECT_LT(d.dtau, honest * sheet.error_dtau() + reference_error);
  EXPECT_LT(sheet.error_tau(), allowed);
  EXPECT_FALSE(c.smooth() && sheet.has_kinks());
}

class SheetOfEveryModel : public testing::TestWithParam<ModelCase> {};

TEST_P(SheetOfEveryModel, SolvesItsEquations) {
  expect_agreement(GetParam(), Amplitude::Type::sine, 8);
  expect_agreement(GetParam(), Amplitude::Type::one_minus_cosine, 8);
}

INSTANTIATE_TEST_SUITE_P(Models, SheetOfEveryModel, testing::ValuesIn(quick_model_cases()),
                         [](const auto& instance) { return instance.param.name; });

class LongSheetOfEveryModel : public testing::TestWithParam<ModelCase> {};

TEST_P(LongSheetOfEveryModel, SolvesItsEquationsFromRestAtOnce) {
  expect_agreement(GetParam(), Amplitude::Type::sine, 20);
}

TEST_P(LongSheetOfEveryModel, SolvesItsEquationsFromRestSmoothly) {
  expect_agreement(GetParam(), Amplitude::Type::one_minus_cosine, 20);
}

INSTANTIATE_TEST_SUITE_P(Models, LongSheetOfEveryModel, testing::ValuesIn(all_model_cases()),
                         [](const auto& instance) { return instance.param.name; });

/// A modulus that is 1e-6 too large is seen.
TEST(SheetNegativeControl, OtherParametersAreCaught) {
  for (const ModelCase& c : quick_model_cases()) {
    if (c.model != "zener" && c.model != "hypoelastic_green_naghdi") continue;
    ModelCase other = c;
    other.parameters["E"] *= 1 + 1e-6;
    const Setting setting = setting_of(c, Amplitude::Type::sine);
    const SheetDifference d = sheet_difference(c, setting, sheet_of(other, setting), 4);
    EXPECT_GT(d.tau, 2e-7) << c.name;
    EXPECT_GT(d.dtau, 2e-7) << c.name;
  }
}

}  // namespace
}  // namespace assay::model_tests::test_sheets
