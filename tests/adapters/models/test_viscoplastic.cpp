// SPDX-License-Identifier: BSD-3-Clause
// norton and perzyna against an independent integration of b_e-dot = l b_e + b_e l^T - 2 Lam n b_e.
#include <gtest/gtest.h>

#include "tests/adapters/models/references/viscoplastic.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_viscoplastic {
namespace {

using Constants = Viscoplasticity;

Material norton(const Constants& c) {
  return material_of(
      "norton",
      {{"E", c.E}, {"nu", c.nu}, {"reference_rate", c.rate}, {"reference_stress", c.stress}, {"exponent", c.exponent}});
}

Material perzyna(const Constants& c) {
  return material_of("perzyna", {{"E", c.E},
                                 {"nu", c.nu},
                                 {"yield_stress", c.yield_stress},
                                 {"hardening_modulus", c.hardening},
                                 {"reference_rate", c.rate},
                                 {"reference_stress", c.stress},
                                 {"exponent", c.exponent}});
}

constexpr Constants smooth{};
constexpr Constants threshold{1000, 0.3, 40, 50, 0.5, 60, 2};

Point reference(const Constants& c, const Path& F, double end) {
  return viscoplastic_point(c, {F, [F](double t) { return Tensor(velocity_gradient(F, t) * F(t)); }, end});
}

/// Loaded to t = 1, unloaded and reversed to t = 3.
Tensor shear_cycle(double t) { return sheared(0.8 * std::sin(0.5 * std::numbers::pi * t)); }
Tensor turning(double t) { return stretched_and_turned(t, 0.5); }

struct Case {
  const char* name;
  Material material;
  Constants constants;
  Path path;
  double end;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  all.push_back({"norton, shear", norton(smooth), smooth, shear_cycle, 3});
  all.push_back({"norton, turning", norton(smooth), smooth, turning, 1});
  all.push_back({"perzyna, shear", perzyna(threshold), threshold, shear_cycle, 3});
  all.push_back({"perzyna, turning", perzyna(threshold), threshold, turning, 1});
  return all;
}

TEST(Viscoplastic, IncrementsConvergeToTheEquationsAtSecondOrder) {
  for (const Case& c : cases()) {
    const Point exact = reference(c.constants, c.path, c.end);
    double stress[3], strain[3];
    for (int k = 0; k < 3; ++k) {
      const Point found = march(c.material, c.path, 0, c.end, 200 << k, at_rest(c.material));
      stress[k] = largest(found.cauchy - exact.cauchy) / largest(exact.cauchy);
      strain[k] = std::abs(found.state[6] - exact.state[0]);
    }
    EXPECT_LT(stress[2], 1e-4) << c.name;
    EXPECT_LT(strain[2], 1e-5) << c.name;
    EXPECT_GT(std::log2(stress[1] / stress[2]), 1.85) << c.name;
    EXPECT_GT(std::log2(strain[1] / strain[2]), 1.85) << c.name;
  }
}

TEST(Viscoplastic, TheReferenceTellsAnotherExponent) {
  Constants other = smooth;
  other.exponent = 4.1;
  const Point right = reference(smooth, shear_cycle, 3), wrong = reference(other, shear_cycle, 3);
  EXPECT_GT(largest(right.cauchy - wrong.cauchy) / largest(right.cauchy), 1e-3);
}

TEST(Viscoplastic, RateIntegratesToTheEquations) {
  for (const Case& c : cases()) {
    const Point exact = reference(c.constants, c.path, c.end);
    const Point found = integrate_rate(c.material, c.path, at_rest(c.material), 0, c.end);
    EXPECT_LT(largest(found.cauchy - exact.cauchy) / largest(exact.cauchy), 1e-8) << c.name;
    EXPECT_NEAR(found.state[6], exact.state[0], 1e-9) << c.name;
  }
}

TEST(Viscoplastic, TangentAndEnergyAgreeWithDifferences) {
  for (const Case& c : cases()) {
    const Point flowing = march(c.material, c.path, 0, 0.8, 40, at_rest(c.material));
    ASSERT_GT(flowing.state[6], 1e-3);
    const Tensor F0 = c.path(0.8), F1 = c.path(0.83);
    EXPECT_LT(tangent_error(c.material, 0.03, F0, F1, flowing.state), 1e-6) << c.name;
    EXPECT_GT(tangent_error(c.material, 0.03, F0, F1, flowing.state, 1e-4), 1e-6) << c.name;
    EXPECT_LT(energy_error(c.material, F0, flowing), 1e-8) << c.name;
    Point planted = flowing;
    planted.cauchy(0, 0) *= 1.0001;
    EXPECT_GT(energy_error(c.material, F0, planted), 1e-8) << c.name;
  }
}

TEST(Viscoplastic, ObjectiveToRoundOff) {
  for (const Case& c : cases()) EXPECT_LT(objectivity_error(c.material, c.path, c.end, 50), 1e-11) << c.name;
}

TEST(Viscoplastic, BelowTheThresholdTheStateKeepsItsBits) {
  const Material material = perzyna(threshold);
  const Point loaded = march(material, shear_cycle, 0, 0.9, 90, at_rest(material));
  ASSERT_GT(loaded.state[6], 0.01);
  const double back = 0.98;  // of the shear: elastic unloading
  const Tensor F0 = shear_cycle(0.9);
  Tensor F1 = F0;
  F1(1, 0) *= back;
  const Point relaxed = march(
      material, [&](double) { return F0; }, 0, 100, 400, loaded);
  const Point elastic = point_after(material, 0, 0.01, F0, F1, relaxed.state);
  EXPECT_EQ(relaxed.state[7], 1);
  EXPECT_EQ(elastic.state[7], 2);
  EXPECT_EQ(point_after(material, 0, 0.01, F1, 0.99 * F1, elastic.state).state[7], 0);
  EXPECT_EQ(std::vector(elastic.state.begin(), elastic.state.begin() + 7),
            std::vector(relaxed.state.begin(), relaxed.state.begin() + 7));
  EXPECT_NE(loaded.state[6], relaxed.state[6]);
  EXPECT_GT(largest(elastic.cauchy - relaxed.cauchy), 1);
}

TEST(Viscoplastic, StiffStepsRelaxAndDoNotGrow) {
  Constants c = smooth;
  for (const double exponent : {1.0, 3.0, 20.0, 100.0}) {
    for (const double rate : {1e-30, 1.0, 1e6, 1e12}) {
      c.exponent = exponent;
      c.rate = rate;
      const Material material = norton(c);
      Point point = at_rest(material);
      double before = 1e300;
      for (int k = 0; k < 20; ++k) {
        point = point_after(material, 0, 1, sheared(k == 0 ? 0 : 0.3), sheared(0.3), point.state);
        const double size = deviator_of(point.cauchy).norm();
        EXPECT_LE(size, before * (1 + 1e-12)) << exponent << ' ' << rate << ' ' << k;
        before = size;
      }
      if (rate >= 1e6 && exponent == 1) {
        EXPECT_LT(before, 1e-3);
      }
    }
  }
}

TEST(Viscoplastic, AJumpRelaxesWithinAStepWithoutOvershoot) {
  for (const Constants& c : {smooth, threshold}) {
    Constants stiff = c;
    stiff.rate = 1e12;
    const Material material = c.yield_stress > 0 ? perzyna(stiff) : norton(stiff);
    const Point jumped = point_after(material, 0, 1, sheared(0.3), sheared(0.3), material.initial_state(1));
    const Point held = march(
        material, [](double) { return sheared(0.3); }, 0, 100, 100, jumped);
    const double left = std::sqrt(1.5) * deviator_of(held.cauchy).norm();
    const double trial =
        std::sqrt(6.0) * c.mu() * deviator_of(0.5 * log_of(sheared(0.3) * sheared(0.3).transpose())).norm();
    EXPECT_NEAR(held.state[6], (trial - left) / (3 * c.mu()), 1e-12);  // sigma_eq + 3 mu p is constant at fixed F
    EXPECT_NEAR(left, c.yield_stress + c.hardening * held.state[6], 1);
    EXPECT_GT(deviator_of(held.cauchy)(0, 1), 0);
  }
}

TEST(Viscoplastic, PerzynaAtGreatRatesIsTheMultiplicativeJ2Model) {
  Constants c = threshold;
  const Material j2 =
      material_of("j2_multiplicative",
                  {{"E", c.E}, {"nu", c.nu}, {"yield_stress", c.yield_stress}, {"hardening_modulus", c.hardening}});
  c.rate = 1e12;
  c.exponent = 1;
  for (const Path& F : {Path(shear_cycle), Path(turning)}) {
    const double end = F(1)(0, 0) == 1 ? 3 : 1;
    const Tensor expected = march(j2, F, 0, end, 3000, at_rest(j2)).cauchy;
    const Material stiff = perzyna(c);
    EXPECT_LT(largest(march(stiff, F, 0, end, 3000, at_rest(stiff)).cauchy - expected), 1e-5 * largest(expected));
    const Material slow = perzyna(threshold);
    EXPECT_GT(largest(march(slow, F, 0, end, 3000, at_rest(slow)).cauchy - expected), 1e-2 * largest(expected));
  }
}

TEST(Viscoplastic, NortonWithExponentOneIsMaxwell) {
  Constants c = smooth;
  c.exponent = 1;
  c.rate = 0.2;
  const Material material = norton(c);
  const Point loaded = point_after(material, 0, 1e-12, Tensor::Identity(), sheared(0.5), material.initial_state(1));
  const Point held = march(
      material, [](double) { return sheared(0.5); }, 0, 2, 400, loaded);
  // d(dev tau)/dt = -3 mu rate / stress dev tau at fixed F.
  const double decay = std::exp(-3 * c.mu() * c.rate / c.stress * 2);
  EXPECT_LT(largest(deviator_of(held.cauchy) - decay * deviator_of(loaded.cauchy)),
            1e-3 * largest(loaded.cauchy) * decay);
  const Tensor I = Tensor::Identity();
  EXPECT_LT(tangent_error(material, 0.3, I, I, material.initial_state(1)), 1e-6);  // flow is linear at rest
}

}  // namespace
}  // namespace assay::model_tests::test_viscoplastic
