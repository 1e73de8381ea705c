// SPDX-License-Identifier: BSD-3-Clause
// What a battery finds does not depend on the unit of stress, as far as the bounds of the models' parameters go.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/check/battery.hpp"
#include "harness/check/share_along.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_size_of_stress {
namespace {

using check::Verdict;

const std::vector<double> moduli{1e-300, 1e-160, 1e160, 1e203, 1e290};  // of Young [Pa]

check::Report report_of(const Material& material) { return check::run_battery(material, {.effort = {.quick = true}}); }

/// The verdicts of every test in turn.
std::string verdicts_of(const check::Report& report) {
  std::string text;
  for (const check::TestResult& test : report.tests) {
    text += test.id + (test.verdict == Verdict::pass   ? " passes\n"
                       : test.verdict == Verdict::fail ? " fails: "
                                                       : " n/a\n");
    if (test.verdict == Verdict::fail) text += test.sentence + "\n";
  }
  return text;
}

std::shared_ptr<const Material> j2(assay_material_entry_function entry, double E) {
  return builtin_material(entry, {{"E", E},
                                  {"nu", 0.3},
                                  {"yield_stress", 0.02 * E},
                                  {"hardening_modulus", 0.03 * E},
                                  {"saturation_stress", 0.015 * E},
                                  {"saturation_rate", 12},
                                  {"kinematic_modulus", 0.08 * E}});
}

template <class Make>
void expect_same(const Make& make, const std::vector<double>& all = moduli) {
  const std::string usual = verdicts_of(report_of(*make(1e3)));
  for (const double E : all) EXPECT_EQ(verdicts_of(report_of(*make(E))), usual) << E;
}

TEST(SizeOfStress, ElasticModelsAreJudgedAlike) {
  expect_same([](double E) { return elastic_material(E); });
  expect_same([](double E) { return builtin_material(assay_builtin_hypoelastic_jaumann, {{"E", E}, {"nu", 0.3}}); });
}

TEST(SizeOfStress, PlasticModelsAreJudgedAlike) {
  const std::vector<double> some{1e-290, 1e160, 1e290};  // a yield stress below 1e-300 Pa is refused
  expect_same([](double E) { return j2(assay_builtin_j2_jaumann, E); }, some);
  expect_same([](double E) { return j2(assay_builtin_j2_multiplicative, E); }, some);
}

TEST(SizeOfStress, ViscousModelsAreJudgedAlike) {
  expect_same([](double E) {
    return builtin_material(assay_builtin_zener,
                            {{"E", E}, {"nu", 0.3}, {"viscous_ratio", 0.5}, {"relaxation_time", 0.2}});
  });
}

TEST(SizeOfStress, AShareIsThatOfAnyUnit) {
  Tensor A, B;
  A << 1, 2, -3, 0, 5, 1, 2, 2, -1;
  B << 0.5, 1, 1, -2, 0, 3, 1, 4, 1;
  const double share = A.cwiseProduct(B).sum() / B.squaredNorm();
  for (const double unit : {1e-300, 1e-200, 1.0, 1e200, 1e305}) {
    EXPECT_NEAR(check::share_along(unit * A, unit * B), share, 1e-14) << unit;
    EXPECT_NEAR(check::share_along(Tensor(1e-3 * unit * A), Tensor(unit * B)), 1e-3 * share, 1e-17) << unit;
  }
}

}  // namespace
}  // namespace assay::test_size_of_stress
