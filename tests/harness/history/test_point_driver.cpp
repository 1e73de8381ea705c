// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/point_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_point_driver {
namespace {

const Vortex small{0.75, 1.25, 2, {Amplitude::Type::sine, 0.3, 1.0}};

/// Jaumann simple shear in closed form: sigma12 = mu sin gamma, sigma11 = mu (cos gamma - 1) with the shear in E2 E1.
Tensor jaumann_tau(double gamma) {
  const double mu = 1e3 / 2.6;
  Tensor sigma = Tensor::Zero(), F = Tensor::Identity();
  F(1, 0) = gamma;
  sigma(0, 1) = sigma(1, 0) = mu * std::sin(gamma);
  sigma(0, 0) = mu * (std::cos(gamma) - 1);
  sigma(1, 1) = -sigma(0, 0);
  return first_piola_kirchhoff(sigma, F);
}

double difference(const Histories& h, const Path& path) {
  double largest = 0;
  for (std::size_t row = 0; row < h.times.size(); ++row) {
    for (std::size_t p = 0; p < h.xi.size(); ++p) {
      const Tensor exact = jaumann_tau(path.deformation_gradient(h.xi[p], h.times[row])(1, 0));
      for (int c = 0; c < 9; ++c) {
        largest = std::max(largest,
                           std::abs(h.tau[row][static_cast<std::size_t>(c) * h.xi.size() + p] - component(exact, c)));
      }
    }
  }
  return largest / (1e3 / 2.6);
}

TEST(PointDriver, TakesAHypoelasticMaterialToItsClosedForm) {
  const Path path = small.baseline();
  const std::vector<double> xi{path.parameter.lower, -0.3, 0.0, 0.5, path.parameter.upper};
  const std::vector<double> times{0, 0.1, 0.5, 0.77, 1.0};  // loading, reversal, unloading
  for (const double tolerance : {1e-6, 1e-10}) {
    const Histories h = integrate_histories(*jaumann_material(), path, xi, times, {.tolerance = tolerance});
    EXPECT_LE(h.error, 100 * tolerance);  // the sum over all steps
    EXPECT_LT(difference(h, path), 10 * tolerance);
  }
}

TEST(PointDriver, TakesMoreCallsForASmallerTolerance) {
  const Path path = small.baseline();
  const std::vector<double> xi{path.parameter.upper}, times{0.5};
  std::int64_t before = 0;
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    const Histories h = integrate_histories(*jaumann_material(), path, xi, times, {.tolerance = tolerance});
    EXPECT_GT(h.material_calls, before);
    before = h.material_calls;
  }
}

TEST(PointDriver, DoesNotDependOnTheNumberOfThreads) {
  const Path path = small.baseline();
  std::vector<double> xi;
  for (int k = 0; k < 20; ++k) xi.push_back(path.parameter.upper * k / 19);
  const std::vector<double> times{0.2, 0.9};
  const Histories one = integrate_histories(*jaumann_material(), path, xi, times);
  const Histories three = integrate_histories(*jaumann_material(), path, xi, times, {.workers = {.threads = 3}});
  EXPECT_EQ(one.tau, three.tau);
  EXPECT_EQ(one.material_calls, three.material_calls);
}

TEST(PointDriver, IsExactForElasticity) {
  const double mu = 1e3 / 2.6;
  const Path path = small.baseline();
  const std::vector<double> xi{-1.0, 0.7}, times{0, 0.25, 0.5};
  const Histories h = integrate_histories(*elastic_material(), path, xi, times);
  EXPECT_LE(h.error, 1e-15);
  for (std::size_t row = 0; row < times.size(); ++row) {
    for (std::size_t p = 0; p < 2; ++p) {
      const double gamma = path.deformation_gradient(xi[p], times[row])(1, 0);
      EXPECT_NEAR(h.tau[row][1 * 2 + p], mu * gamma, 1e-12);
      EXPECT_NEAR(h.tau[row][0 * 2 + p], 0, 1e-12);
    }
  }
}

TEST(PointDriver, FollowsUniaxialStrain) {
  Homogeneous motion;
  motion.final(0, 0) = 2;
  const Path path = motion.baseline();
  EXPECT_EQ(path.name, "uniaxial_strain");
  const double E = 1e6, nu = 0.25, mu = E / 2.5, lambda = E * nu / (1.25 * 0.5);
  const std::vector<double> xi{1.0}, times{0.4, 1.0};
  const Histories h = integrate_histories(*elastic_material(E, nu), path, xi, times);
  for (std::size_t row = 0; row < 2; ++row) {
    const double s = 1 + times[row];
    EXPECT_NEAR(h.tau[row][0], (lambda * std::log(s) + mu * (s * s - 1)) / s, 1e-9 * E);  // (39)
    EXPECT_NEAR(h.tau[row][4], lambda * std::log(s), 1e-9 * E);                           // (40) times the stretch
  }
}

TEST(PointDriver, ReportsWhereAMaterialFails) {
  const Path path = small.baseline();
  const std::vector<double> xi{0.1, path.parameter.upper}, times{0.1, 0.5};
  try {
    integrate_histories(*jaumann_material(0.5), path, xi, times);
    FAIL() << "no failure reported";
  } catch (const MaterialFailure& failure) {
    EXPECT_STREQ(failure.what(), "sheared too far");
    EXPECT_TRUE(failure.xi == path.parameter.upper || failure.xi == path.parameter.lower);
    const double gamma = path.deformation_gradient(failure.xi, failure.t)(1, 0);
    EXPECT_NEAR(std::abs(gamma), 0.5, 0.05) << "the failing step begins before and ends behind the limit";
    ASSERT_TRUE(failure.step);
    EXPECT_NEAR(failure.step->t + failure.step->dt, failure.t, 1e-15);
  }
}

}  // namespace
}  // namespace assay::test_point_driver
