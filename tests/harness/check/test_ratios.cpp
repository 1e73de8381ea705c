// SPDX-License-Identifier: BSD-3-Clause
// Right models pass at every ratio of Poisson that their bounds leave, as far as people use it.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "harness/check/battery.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_ratios {
namespace {

constexpr double ratios[] = {-0.9, 0, 0.499, 0.49999};

void expect_right(const char* name, assay_material_entry_function entry, const std::map<std::string, double>& others) {
  for (const double nu : ratios) {
    std::map<std::string, double> parameters = others;
    parameters["E"] = 1e3, parameters["nu"] = nu;
    const check::Report report = check::run_battery(*builtin_material(entry, parameters), {.effort = {.quick = true}});
    EXPECT_TRUE(report.passes()) << name << " at nu = " << nu << ": "
                                 << (report.diagnosis.empty() ? "" : report.diagnosis[0].sentence);
  }
}

TEST(Ratios, ElasticModelsPass) {
  expect_right("neo_hookean", assay_builtin_neo_hookean, {});
  expect_right("hypoelastic_green_naghdi", assay_builtin_hypoelastic_green_naghdi, {});
  expect_right("hypoelastic_jaumann", assay_builtin_hypoelastic_jaumann, {});
}

TEST(LongRatios, PlasticModelsPass) {
  const std::map<std::string, double> soft{{"yield_stress", 5}, {"hardening_modulus", 50}};
  expect_right("j2_jaumann", assay_builtin_j2_jaumann, soft);
  expect_right("j2_multiplicative", assay_builtin_j2_multiplicative, soft);
}

TEST(Ratios, ViscousModelsPass) { expect_right("zener", assay_builtin_zener, {{"relaxation_time", 1}}); }

}  // namespace
}  // namespace assay::test_ratios
