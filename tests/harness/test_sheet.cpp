// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/homogeneous.hpp"
#include "harness/point_driver.hpp"
#include "harness/response.hpp"
#include "harness/vortex.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay {
namespace {

struct Difference {
  double tau = 0, dtau = 0;
};

/// Against a closed form at places off any node, relative to the largest component.
template <class Exact>
Difference largest_difference(const Sheet& sheet, const Path& path, double end, const Exact& exact) {
  Difference d;
  double tau_scale = 0, dtau_scale = 0;
  for (int i = 0; i < 23; ++i) {
    for (int j = 0; j < 29; ++j) {
      const double xi = path.parameter.lower + path.parameter.width() * (i + 0.37) / 23, t = end * (j + 0.61) / 29;
      Tensor tau, dtau, tau_exact, dtau_exact;
      sheet.slice(t).at(xi, tau, dtau);
      exact(xi, t, tau_exact, dtau_exact);
      d.tau = std::max(d.tau, (tau - tau_exact).cwiseAbs().maxCoeff());
      d.dtau = std::max(d.dtau, (dtau - dtau_exact).cwiseAbs().maxCoeff());
      tau_scale = std::max(tau_scale, tau_exact.cwiseAbs().maxCoeff());
      dtau_scale = std::max(dtau_scale, dtau_exact.cwiseAbs().maxCoeff());
    }
  }
  return {d.tau / tau_scale, d.dtau / dtau_scale};
}

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

/// Jaumann hypoelasticity: sigma12 = mu sin gamma; the increments need sub-stepping, the slope is known too.
void jaumann(const Path& path, double xi, double t, Tensor& tau, Tensor& dtau) {
  const double mu = 1e3 / 2.6, g = path.amplitude(t), gamma = 2 * xi * g;
  const auto at = [&](double s12, double s11) {
    Tensor sigma = Tensor::Zero();
    sigma(0, 1) = sigma(1, 0) = s12;
    sigma(0, 0) = s11;
    sigma(1, 1) = -s11;
    return sigma;
  };
  const Tensor sigma = at(mu * std::sin(gamma), mu * (std::cos(gamma) - 1));
  const Tensor slope = at(mu * std::cos(gamma), -mu * std::sin(gamma));
  Tensor inverse_transpose = Tensor::Identity(), change = Tensor::Zero();
  inverse_transpose(0, 1) = -gamma;  // F^-T, J = 1
  change(0, 1) = -1;
  tau = sigma * inverse_transpose;
  dtau = 2 * g * (slope * inverse_transpose + sigma * change);
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

TEST(Sheet, OfAPathIndependentMaterialIsACurveThatHoldsForAllTimes) {
  const Path path = Vortex{}.baseline();
  const Sheet sheet(*elastic_material(), path, {.end = 1e9});
  EXPECT_TRUE(sheet.is_curve());
  EXPECT_LT(sheet.points(), 100);
  const auto form = *ClosedForm::of(elastic_material(), path);
  for (const double t : {0.3, 1.6, 123456.7}) {
    Tensor tau, dtau, exact, exact_slope;
    sheet.slice(t).at(-2.1, tau, dtau);
    form.at(-2.1, t, exact, exact_slope);
    EXPECT_LT((tau - exact).norm(), 1e-11 * 1e3);
    EXPECT_LT((dtau - exact_slope).norm(), 1e-10 * 1e3);
  }
  const Path brief = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
  EXPECT_FALSE(Sheet(*jaumann_material(), brief, {.tolerance = 1e-4, .end = 1}).is_curve());
}

TEST(Sheet, ServesPathsThatNeverLoad) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.0, 1.0}}.baseline();
  const Sheet sheet(*elastic_material(), path, {.end = 1});
  Tensor tau, dtau;
  sheet.slice(0.5).at(1.0, tau, dtau);
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
}  // namespace assay
