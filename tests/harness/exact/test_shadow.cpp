// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "harness/exact/response.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_shadow {
namespace {

const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}}.baseline();
const std::map<std::string, double> plastic{{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", 20}};
const std::map<std::string, double> elastic{{"E", 1000}, {"nu", 0.3}};

/// Largest difference to a sheet over some steps, relative.
double difference_to_sheet(const std::shared_ptr<const Material>& material, int radii, double& stated) {
  const Sheet sheet(*material, path, {.tolerance = 1e-7, .end = 1});
  Shadow shadow(material, path, {.radii = radii, .tolerance = 1e-7, .end = 1});
  double largest = 0;
  for (int step = 1; step <= 20; ++step) {
    const double t = step / 20.0;
    shadow.advance(t);
    for (int k = 0; k < 301; ++k) {
      const double xi = path.parameter.lower + path.parameter.width() * k / 300;
      Tensor tau, slope, exact, exact_slope;
      shadow.curve()->at(xi, tau, slope);
      sheet.at(xi, t, exact, exact_slope);
      largest = std::max(largest, (tau - exact).cwiseAbs().maxCoeff());
    }
  }
  stated = shadow.error();
  return largest / sheet.error().tau_scale;
}

TEST(LongShadow, ConvergesToTheSheetWithTheNumberOfRadii) {
  double stated = 0;
  const auto smooth = builtin_material(assay_builtin_hypoelastic_green_naghdi, elastic);
  const double coarse = difference_to_sheet(smooth, 30, stated);
  EXPECT_LT(coarse, stated) << "the stated error is a bound";
  const double fine = difference_to_sheet(smooth, 120, stated);
  EXPECT_LT(fine, coarse / 100) << "cubics";
  EXPECT_LT(fine, stated);
  const auto kinked = builtin_material(assay_builtin_j2_jaumann, plastic);
  const double few = difference_to_sheet(kinked, 60, stated);
  EXPECT_LT(few, stated);
  const double many = difference_to_sheet(kinked, 360, stated);
  EXPECT_LT(many, few / 3) << "a straight line over each front";
  EXPECT_LT(many, stated);
}

TEST(Shadow, KnowsWhereTheFrontsAre) {
  const auto material = builtin_material(assay_builtin_j2_jaumann, plastic);
  const auto shadow = std::make_shared<Shadow>(material, path, ShadowOptions{.radii = 400, .end = 1});
  const Response response(shadow);
  const Sheet sheet(*material, path, {.tolerance = 1e-6, .end = 1});
  const double spacing = path.parameter.width() / 399;
  for (const double t : {0.1, 0.3, 0.8}) {
    const std::vector<double> found = response.at_time(t)->fronts(), exact = sheet.isochrone(t).kinks();
    EXPECT_FALSE(found.empty());
    for (const double front : found) {
      double nearest = 1e9;
      for (const double kink : exact) nearest = std::min(nearest, std::abs(kink - front));
      EXPECT_LT(nearest, spacing) << "at " << t;
    }
  }
  EXPECT_EQ(response.shadow()->t(), 0.8);
  EXPECT_EQ(response.sheet(), nullptr);
}

}  // namespace
}  // namespace assay::test_shadow
