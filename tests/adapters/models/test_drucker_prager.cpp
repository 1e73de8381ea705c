// SPDX-License-Identifier: BSD-3-Clause
// drucker_prager against an independent integration of its flow between events that are found by bisection.
#include <gtest/gtest.h>

#include "tests/adapters/models/references/drucker_prager.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_drucker_prager {
namespace {

using drucker_prager::Reference;
using Constants = drucker_prager::Cone;

Material cone(const Constants& c) {
  return material_of("drucker_prager", {{"E", c.E},
                                        {"nu", c.nu},
                                        {"cohesion", c.cohesion},
                                        {"friction", c.friction},
                                        {"dilatancy", c.dilatancy},
                                        {"hardening_modulus", c.hardening}});
}

/// Along a path that turns back at all of `turns` but the last.
Reference reference(const Constants& c, const Path& F, const std::vector<double>& turns) {
  const auto F_rate = [F](double t) { return Tensor(velocity_gradient(F, t) * F(t)); };
  return drucker_prager::reference(c, {F, F_rate, turns.back(), {turns.begin(), turns.end() - 1}});
}

/// Pressed and sheared to t = 1, sheared back and reversed to t = 3.
Tensor pressed_shear(double t) {
  Tensor press = Tensor::Identity();
  press(0, 0) -= 0.02 * std::sin(0.5 * std::numbers::pi * t) * std::sin(0.5 * std::numbers::pi * t);
  return sheared(0.3 * std::sin(0.5 * std::numbers::pi * t)) * press;
}

Tensor turning(double t) {
  return Eigen::AngleAxisd(2 * t, Vector3(1, 2, 3).normalized()).toRotationMatrix() * sheared(0.4 * t) *
         Tensor((1 - 0.02 * t) * Tensor::Identity());
}

struct Case {
  const char* name;
  Constants constants;
  Path path;
  std::vector<double> turns;
};

std::vector<Case> cases() {
  Constants perfect;
  perfect.hardening = 0;
  return {{"hardening, pressed shear", Constants{}, pressed_shear, {1, 3}},
          {"hardening, turning", Constants{}, turning, {1}},
          {"perfect, pressed shear", perfect, pressed_shear, {1, 3}},
          {"perfect, turning", perfect, turning, {1}}};
}

TEST(DruckerPrager, ConeConvergesToTheEquationsAtSecondOrder) {
  for (const Case& c : cases()) {
    const Material material = cone(c.constants);
    const Reference exact = reference(c.constants, c.path, c.turns);
    ASSERT_GT(exact.p, 0.01);
    double error[2];
    for (int k = 0; k < 2; ++k) {
      const Point found = march(material, c.path, 0, c.turns.back(), k ? 2400 : 150, at_rest(material));
      error[k] = largest(found.cauchy - exact.cauchy) / largest(exact.cauchy);
      EXPECT_NEAR(found.state[6], exact.p, k ? 1e-8 : 1e-5) << c.name;
      EXPECT_EQ(found.state[7], 0) << c.name;
    }
    EXPECT_LT(error[1], 1e-7) << c.name;
    EXPECT_GT(std::log2(error[0] / error[1]) / 4, 1.8) << c.name;
  }
}

TEST(DruckerPrager, TheReferenceTellsAssociatedFlow) {
  Constants associated;
  associated.dilatancy = associated.friction;
  const Reference right = reference(Constants{}, pressed_shear, {1}), wrong = reference(associated, pressed_shear, {1});
  EXPECT_GT(largest(right.cauchy - wrong.cauchy) / largest(right.cauchy), 1e-2);
}

TEST(DruckerPrager, RateIntegratesToTheEquationsFromTheYieldPoint) {
  for (const Case& c : cases()) {
    const Material material = cone(c.constants);
    const Reference exact = reference(c.constants, c.path, {1});
    const double begin = exact.yields[0];
    Point yielding = point_after(material, 0, begin, Tensor::Identity(), c.path(begin), material.initial_state(1));
    ASSERT_EQ(yielding.state[6], 0);
    const Point found = integrate_rate(material, c.path, yielding, begin, 0.9);
    const Point increments = march(material, c.path, begin, 0.9, 4000, yielding);
    EXPECT_LT(largest(found.cauchy - increments.cauchy) / largest(found.cauchy), 1e-7) << c.name;
    EXPECT_NEAR(found.state[6], increments.state[6], 1e-8) << c.name;
    EXPECT_GT(found.state[6], 0.005) << c.name;
  }
}

/// Pulled apart while sheared: ends at the apex.
Tensor pulled(double t) { return sheared(0.02 * t) * Tensor((1 + 0.1 * t) * Tensor::Identity()); }

TEST(DruckerPrager, ApexCarriesItsPressureOnly) {
  for (const double hardening : {0.0, 30.0}) {
    Constants c;
    c.hardening = hardening;
    const Material material = cone(c);
    const Point found = march(material, pulled, 0, 1, 50, at_rest(material));
    const double ln_J = std::log(pulled(1).determinant()), root3 = std::sqrt(3.0);
    // friction 3 kappa tr(e) = k; what tr(e) leaves of ln J has flowed: 3 dilatancy sqrt(3) p on the cone, v here.
    const double k = c.cohesion + hardening * (found.state[6] + found.state[7] / (3 * root3 * c.dilatancy));
    const double volume = k / (3 * c.friction * c.kappa());
    EXPECT_NEAR(found.state[7] + 3 * c.dilatancy * root3 * found.state[6], ln_J - volume, 1e-12);
    EXPECT_GT(found.state[7], 0.1);
    EXPECT_LT(largest(found.cauchy * pulled(1).determinant() - k / (3 * c.friction) * Tensor::Identity()), 1e-10);
    const Point further = point_after(material, 1, 0.1, pulled(1), pulled(1.1), found.state);
    EXPECT_EQ(further.state[6], found.state[6]);  // the apex alone
    EXPECT_NE(further.state[7], found.state[7]);
    const Point pressed = point_after(material, 1, 0.1, pulled(1), Tensor(0.999 * pulled(1)), found.state);
    EXPECT_EQ(pressed.state, found.state);
    const Point rate = integrate_rate(material, pulled, found, 1, 1.5);
    const Point increments = march(material, pulled, 1, 1.5, 10, found);
    EXPECT_LT(largest(rate.cauchy - increments.cauchy), 1e-8);
    EXPECT_NEAR(rate.state[7], increments.state[7], 1e-9);
  }
}

TEST(DruckerPrager, TheReturnIsContinuousWhereConeAndApexMeet) {
  const Material material = cone(Constants{});
  const Tensor I = Tensor::Identity();
  const auto stretched = [&](double shear) { return Tensor(sheared(shear) * Tensor(1.05 * I)); };
  const auto at_apex = [&](double shear) {
    return point_after(material, 0, 1, stretched(shear), stretched(shear), material.initial_state(1)).state[7] > 0;
  };
  double low = 0, high = 2;
  ASSERT_TRUE(at_apex(low) && !at_apex(high));
  for (int k = 0; k < 50; ++k) (at_apex(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  const auto end = [&](double shear) {
    return point_after(material, 0, 1, stretched(shear), stretched(shear), material.initial_state(1)).cauchy;
  };
  EXPECT_LT(largest(end(high) - end(low)), 1e-9);
}

TEST(DruckerPrager, TangentAndEnergyAgreeWithDifferences) {
  for (const Path& F : {Path(pressed_shear), Path(turning), Path(pulled)}) {
    const Material material = cone(Constants{});
    const Point flowing = march(material, F, 0, 0.8, 40, at_rest(material));
    ASSERT_GT(flowing.state[6] + flowing.state[7], 1e-3);
    EXPECT_LT(tangent_error(material, 0.03, F(0.8), F(0.83), flowing.state), 1e-6);
    EXPECT_GT(tangent_error(material, 0.03, F(0.8), F(0.83), flowing.state, 1e-2), 1e-6);
    EXPECT_LT(tangent_error(material, 0.03, F(0.8), F(0.7), flowing.state), 1e-6);
    EXPECT_LT(energy_error(material, F(0.8), flowing), 1e-8);
    Point planted = flowing;
    planted.cauchy(0, 0) *= 1.0001;
    EXPECT_GT(energy_error(material, F(0.8), planted), 1e-8);
  }
}

TEST(DruckerPrager, ObjectiveToRoundOff) {
  for (const Case& c : cases()) {
    EXPECT_LT(objectivity_error(cone(c.constants), c.path, c.turns.back(), 50), 1e-11) << c.name;
  }
}

TEST(DruckerPrager, StartsUnderAStressInsideTheCone) {
  const Material material = cone(Constants{});
  Tensor sigma;
  sigma << -40, 3, 1, 3, -35, 2, 1, 2, -45;
  const auto nine = components_of(sigma);
  const Tensor I = Tensor::Identity();
  const Point rest = point_after(material, 0, 1, I, I, material.initial_state(1, nine));
  EXPECT_LT(largest(rest.cauchy - sigma), 1e-12 * 45);
  const auto pulling = components_of(Tensor(100 * I));
  EXPECT_THROW(material.initial_state(1, pulling), std::runtime_error);
}

TEST(DruckerPrager, RefusesNegativePlasticWorkAndAnApexThatCannotHarden) {
  Constants c;
  c.dilatancy = 0.3;
  EXPECT_THROW(cone(c), std::runtime_error);
  c.dilatancy = 0;
  EXPECT_THROW(cone(c), std::runtime_error);
  c.hardening = 0;
  EXPECT_NO_THROW(cone(c));
}

TEST(DruckerPrager, WithoutFrictionItIsVonMises) {
  Constants c;
  c.friction = c.dilatancy = 0;
  const Material material = cone(c);
  const Point found = march(material, pulled, 0, 1, 20, at_rest(material));
  EXPECT_EQ(found.state[7], 0);
  const double J = pulled(1).determinant();
  EXPECT_NEAR(found.cauchy.trace() / 3, c.kappa() * std::log(J) / J, 1e-10);
}

}  // namespace
}  // namespace assay::model_tests::test_drucker_prager
