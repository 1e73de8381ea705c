// SPDX-License-Identifier: BSD-3-Clause
// A body at rest that drives itself on is a defect; one that nothing resists in some strain is none.
#include "harness/check/tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/harness/check/model_table.hpp"

namespace assay::check::test_positive_stiffness {
namespace {

using check_tests::PointStep;

/// sigma = (K ln J + pull |ln J|) I / J + G (b - I)/J, and a viscous pressure, all in single precision where it is
/// asked for.
struct Law {
  static constexpr std::size_t state_size = 0;
  double bulk, shear, one_sided, viscosity;
  bool is_single;

  explicit Law(const double* p) : bulk(p[0]), shear(p[1]), one_sided(p[2]), viscosity(p[3]), is_single(p[4] != 0) {}
  bool rest(const Tensor&, double*) const { return true; }
  void misbehave(std::size_t, double*, double*) const {}

  std::optional<Tensor> take(const PointStep& step, const double*, double*) const {
    const Tensor F = rounded(step.F1), b = F * F.transpose(), I = Tensor::Identity();
    const double ln_J = std::log(F.determinant());
    if (!(F.determinant() > 0)) return std::nullopt;
    const double rate = (ln_J - std::log(step.F0.determinant())) / step.dt;
    const double tension = bulk * ln_J + one_sided * std::abs(ln_J) + viscosity * rate;
    const Tensor isochoric = std::exp(-2 * ln_J / 3) * b;
    return rounded((tension * I + shear * check_tests::deviator(isochoric)) / F.determinant());
  }

  Tensor rounded(const Tensor& A) const { return is_single ? Tensor(A.cast<float>().cast<double>()) : A; }
};

Material law(double bulk, double shear, std::map<std::string, double> more = {}) {
  static const assay_parameter parameters[] = {{"bulk", "Pa", 0, -1e12, 1e12, ""},
                                               {"shear", "Pa", 0, -1e12, 1e12, ""},
                                               {"one_sided", "Pa", 0, -1e12, 1e12, ""},
                                               {"viscosity", "Pa s", 0, 0, 1e12, ""},
                                               {"single", "1", 0, 0, 1, ""}};
  static const assay_material table = check_tests::table_of<Law>("law_for_tests", 0, parameters, {});
  static const assay_material viscous =
      check_tests::table_of<Law>("viscous_law_for_tests", ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT, parameters, {});
  const bool is_viscous = more.count("viscosity") == 1;
  more["bulk"] = bulk, more["shear"] = shear;
  return {is_viscous ? &viscous : &table, more};
}

TestResult judged(const Material& material) { return positive_stiffness(examine(material, {})); }

std::string first_cause(const Material& material) {
  const Report report = run_battery(material, {.effort = {.quick = true}});
  return report.passes() ? "" : report.diagnosis.front().cause;
}

TEST(PositiveStiffness, ANegativeModulusIsNamedHoweverSmallItIs) {
  for (const double bulk : {-300.0, -10.0, -0.2}) {
    const TestResult found = judged(law(bulk, 500));
    EXPECT_EQ(found.cause, causes::not_positive) << bulk;
    EXPECT_NE(found.sentence.find("the bulk modulus at rest is -"), std::string::npos) << found.sentence;
  }
  EXPECT_EQ(first_cause(law(-10, 500)), causes::not_positive);
  for (const double shear : {-300.0, -1.0}) {
    const TestResult found = judged(law(500, shear));
    EXPECT_EQ(found.cause, causes::not_positive) << shear;
    EXPECT_NE(found.sentence.find("gives a stress that increases it: the stiffness against it is -"), std::string::npos)
        << found.sentence;
  }
}

TEST(PositiveStiffness, WhatIsLeftInTheEndCountsWhereARateHidesIt) {
  const Material material = law(-100, 500, {{"viscosity", 1e6}});
  EXPECT_EQ(judged(material).cause, causes::not_positive);
  EXPECT_EQ(judged(law(100, 500, {{"viscosity", 1e6}})).verdict, Verdict::pass);
}

/// Of a fluid, of what has a stiffness against shear alone, of rubber; in single precision they leave noise.
TEST(PositiveStiffness, NoneIsNoDefect) {
  for (const double single : {0.0, 1.0}) {
    for (const auto& [bulk, shear] : {std::pair{1e9, 0.0}, {0.0, 500.0}, {1e5, 1.0}, {2e9, 1e5}, {3e5, 1e2}}) {
      const TestResult found = judged(law(bulk, shear, {{"single", single}}));
      EXPECT_NE(found.verdict, Verdict::fail) << bulk << " " << shear << " " << single << ": " << found.sentence;
      const std::string named = single == 0 && bulk > 0 ? first_cause(law(bulk, shear)) : "";
      EXPECT_EQ(named, "") << bulk << " " << shear;
    }
  }
}

/// Stiffer in tension than in pressure there is no stiffness at rest: the work of a change of volume tells.
TEST(PositiveStiffness, AChangeOfVolumeByItselfIsTried) {
  const Material material = law(-20, 500, {{"one_sided", 5.0}});
  const Specimen specimen = examine(material, {});
  EXPECT_EQ(positive_stiffness(specimen).verdict, Verdict::not_applicable);
  const TestResult found = dissipation(specimen);
  EXPECT_EQ(found.cause, causes::dissipation);
  EXPECT_NE(found.sentence.find("in a change of volume from rest and back"), std::string::npos) << found.sentence;
  EXPECT_EQ(dissipation(examine(law(20, 500, {{"one_sided", 5.0}}), {})).verdict, Verdict::pass);
}

TEST(PositiveStiffness, EllipticityThatIsLostAtRestIsToldThere) {
  const Material lost = law(-900, 500), later = law(0, 500);
  const std::string words = ellipticity(examine(lost, {})).sentence;
  for (const char* place : {"simple shear: lost at gamma = 0;", "uniaxial extension: lost at strain = 0;",
                            "uniaxial compression: lost at strain = 0"}) {
    EXPECT_NE(words.find(place), std::string::npos) << words;
  }
  EXPECT_EQ(words.find("-0"), std::string::npos) << words;
  EXPECT_EQ(ellipticity(examine(later, {})).sentence.find("= 0;"), std::string::npos);
}

}  // namespace
}  // namespace assay::check::test_positive_stiffness
