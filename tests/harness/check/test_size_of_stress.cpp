// SPDX-License-Identifier: BSD-3-Clause
// What a battery finds does not depend on the unit of stress, as far as the bounds of the models' parameters go.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/check/battery.hpp"
#include "harness/check/march.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_size_of_stress {
namespace {

using check::Verdict;

/// Young's moduli [Pa]; of models with smaller parameters beside it, which must not be below 1e-300 Pa either, the
/// second.
const std::vector<double> moduli{1e-300, 1e-160, 1e160, 1e203, 1e290}, with_others{1e-290, 1e290};

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
void expect_same(const Make& make, const std::vector<double>& all = with_others) {
  const std::string usual = verdicts_of(report_of(*make(1e3)));
  for (const double E : all) EXPECT_EQ(verdicts_of(report_of(*make(E))), usual) << E;
}

TEST(LongSizeOfStress, ElasticModelsAreJudgedAlike) {
  expect_same([](double E) {
    return builtin_material(assay_builtin_orthotropic_cylindrical, {{"E_r", E},
                                                                    {"E_t", 2 * E},
                                                                    {"E_z", 1.5 * E},
                                                                    {"nu_rt", 0.2},
                                                                    {"nu_rz", 0.2},
                                                                    {"nu_tz", 0.2},
                                                                    {"G_rt", 0.4 * E},
                                                                    {"G_rz", 0.4 * E},
                                                                    {"G_tz", 0.4 * E}});
  });
  expect_same([](double E) { return elastic_material(E); }, moduli);
  expect_same([](double E) { return builtin_material(assay_builtin_hypoelastic_jaumann, {{"E", E}, {"nu", 0.3}}); });
}

TEST(LongSizeOfStress, PlasticModelsAreJudgedAlike) {
  expect_same([](double E) { return j2(assay_builtin_j2_jaumann, E); });
  expect_same([](double E) { return j2(assay_builtin_j2_multiplicative, E); });
  expect_same([](double E) {
    return builtin_material(assay_builtin_drucker_prager, {{"E", E},
                                                           {"nu", 0.3},
                                                           {"cohesion", 0.015 * E},
                                                           {"friction", 0.2},
                                                           {"dilatancy", 0.1},
                                                           {"hardening_modulus", 0.02 * E}});
  });
}

TEST(SizeOfStress, ViscousModelsAreJudgedAlike) {
  expect_same([](double E) {
    return builtin_material(assay_builtin_zener,
                            {{"E", E}, {"nu", 0.3}, {"viscous_ratio", 0.5}, {"relaxation_time", 0.2}});
  });
  expect_same([](double E) {
    return builtin_material(assay_builtin_perzyna, {{"E", E},
                                                    {"nu", 0.3},
                                                    {"yield_stress", 0.02 * E},
                                                    {"hardening_modulus", 0.03 * E},
                                                    {"reference_rate", 0.5},
                                                    {"reference_stress", 0.03 * E},
                                                    {"exponent", 3}});
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
