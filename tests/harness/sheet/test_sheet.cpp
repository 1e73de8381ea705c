// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/exact/response.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/bilinear_material.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"
#include "tests/harness/sheet_difference.hpp"

namespace assay::test_sheet {
namespace {

TEST(Sheet, IsTheClosedFormOfElasticityOnBothBaselines) {
  Homogeneous stretch;
  stretch.final(0, 0) = 3;
  for (const Path& path : {Vortex{}.baseline(), stretch.baseline(),
                           Vortex{0.75, 1.25, 2, {Amplitude::Type::one_minus_cosine, 2.0, 0.3}}.baseline()}) {
    const double end = 1;
    const Sheet sheet(*elastic_material(), path, {.tolerance = 1e-11, .end = end});
    const auto form = *ClosedForm::of(elastic_material(), path);
    const Difference d = largest_difference(
        sheet, path, end, [&](double xi, double t, Tensor& tau, Tensor& dtau) { form.at(xi, t, tau, dtau); });
    EXPECT_LT(d.tau, 1e-11) << path.name;
    EXPECT_LT(d.dtau, 1e-10) << path.name;
    EXPECT_LT(sheet.error_tau(), 1e-11);
  }
}

TEST(Sheet, StatesItsErrorForAMaterialWithHistory) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.3, 1.0}}.baseline();
  for (const double tolerance : {1e-5, 1e-8}) {
    const Sheet sheet(*jaumann_material(), path, {.tolerance = tolerance, .end = 1});
    const Difference d = largest_difference(
        sheet, path, 1, [&](double xi, double t, Tensor& tau, Tensor& dtau) { jaumann(path, xi, t, tau, dtau); });
    EXPECT_LE(sheet.error_tau(), tolerance);
    EXPECT_LT(d.tau, 10 * tolerance);
    EXPECT_LT(d.dtau, 10 * tolerance);
    EXPECT_GT(sheet.material_calls(), sheet.points());
  }
}

TEST(Sheet, TellsHowFarItIs) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.3, 1.0}}.baseline();
  SheetOptions options{.tolerance = 1e-8, .end = 1};
  std::vector<SheetProgress> seen;
  int polls = 0;
  options.workers.poll = [&] { ++polls; };
  options.report = [&](const SheetProgress& now) { seen.push_back(now); };
  const Sheet sheet(*jaumann_material(), path, options);
  ASSERT_FALSE(seen.empty());
  EXPECT_GE(polls, static_cast<int>(seen.size())) << "one that is interrupted stops";
  bool measured = false;
  for (const SheetProgress& now : seen) {
    EXPECT_LE(now.done, now.planned);
    measured = measured || now.stage == SheetProgress::Stage::error;
  }
  EXPECT_TRUE(measured);
  EXPECT_EQ(seen.front().stage, SheetProgress::Stage::histories) << "it has no kinks to look for";
  EXPECT_LT(seen.front().done, seen.front().planned);
}

TEST(Sheet, OfAPathIndependentMaterialIsACurveThatHoldsForAllTimes) {
  const Path path = Vortex{}.baseline();
  const Sheet sheet(*elastic_material(), path, {.end = 1e9});
  EXPECT_TRUE(sheet.is_curve());
  EXPECT_LT(sheet.points(), 100);
  const auto form = *ClosedForm::of(elastic_material(), path);
  for (const double t : {0.3, 1.6, 123456.7}) {
    Tensor tau, dtau, exact, exact_slope;
    sheet.isochrone(t).at(-2.1, tau, dtau);
    form.at(-2.1, t, exact, exact_slope);
    EXPECT_LT((tau - exact).norm(), 1e-11 * 1e3);
    EXPECT_LT((dtau - exact_slope).norm(), 1e-10 * 1e3);
  }
  const Path brief = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  EXPECT_FALSE(Sheet(*jaumann_material(), brief, {.tolerance = 1e-4, .end = 1}).is_curve());
}

/// A bilinear elastic solid's kink lies between the places at which a curve is compared with the material.
TEST(Sheet, OfACurveWithAKinkStatesWhatItLacks) {
  const auto bilinear = bilinear_material(0.113);
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  const Sheet sheet(*bilinear, path, {.tolerance = 1e-8, .end = 1});
  ASSERT_TRUE(sheet.is_curve());
  EXPECT_GT(sheet.error_tau(), 1e-5);
  double largest = 0, scale = 0;
  for (double xi = path.parameter.lower; xi < path.parameter.upper; xi += 0.003 * path.parameter.width()) {
    Tensor tau, dtau;
    sheet.isochrone(0.5).at(xi, tau, dtau);
    const double exact = bilinear_stress(0.113, 2 * xi * 0.1);
    largest = std::max(largest, std::abs(tau(1, 0) - exact));
    scale = std::max(scale, std::abs(exact));
  }
  EXPECT_LT(largest / scale, 3 * sheet.error_tau());
  EXPECT_GT(largest / scale, 1e-5);
}

/// 50 radians of shear, stress by its sine: the range is halved, and a half is not a kink.
TEST(Sheet, OfASmoothMaterialHasNoKinksHoweverFinelyItIsDivided) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::one_minus_cosine, 7, 1.0}}.baseline();
  const Sheet sheet(*builtin_material(assay_builtin_hypoelastic_jaumann, {{"E", 1e3}, {"nu", 0.3}}), path,
                    {.tolerance = 1e-6, .end = 0.5});
  EXPECT_GT(sheet.nodes_in_xi(), 80);
  EXPECT_FALSE(sheet.has_kinks());
  EXPECT_TRUE(sheet.isochrone(0.4).kinks().empty());
  const Difference d = largest_difference(
      sheet, path, 0.5, [&](double xi, double t, Tensor& tau, Tensor& dtau) { jaumann(path, xi, t, tau, dtau); });
  EXPECT_LT(d.tau, 1e-5);
}

TEST(Sheet, ServesPathsThatNeverLoad) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.0, 1.0}}.baseline();
  const Sheet sheet(*elastic_material(), path, {.end = 1});
  Tensor tau, dtau;
  sheet.isochrone(0.5).at(1.0, tau, dtau);
  EXPECT_EQ(tau.norm(), 0);
}

TEST(Sheet, PassesAFailureOn) {
  const Path path = Vortex{}.baseline();
  EXPECT_THROW(Sheet(*jaumann_material(1.0), path, {.end = 1}), MaterialFailure);
}

TEST(Response, NamesNoClosedFormWhereThereIsNone) {
  EXPECT_FALSE(ClosedForm::of(jaumann_material(), Vortex{}.baseline()));
  Homogeneous shear;
  shear.final(0, 1) = 0.3;
  EXPECT_FALSE(ClosedForm::of(elastic_material(), shear.baseline()));
}

}  // namespace
}  // namespace assay::test_sheet
