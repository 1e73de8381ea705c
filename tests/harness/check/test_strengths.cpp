// SPDX-License-Identifier: BSD-3-Clause
// Right models pass however small their strength is beside their stiffness, or refuse it when they are made.
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "harness/check/battery.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_strengths {
namespace {

constexpr double strengths[] = {1e-5, 1e-8, 1e-10, 1e-300};  // of E

void expect_right(const char* name, assay_material_entry_function entry, const char* strength,
                  std::map<std::string, double> parameters) {
  constexpr double E = 1e3;
  parameters["E"] = E;
  for (const double share : strengths) {
    parameters[strength] = share * E;
    std::shared_ptr<const Material> material;
    try {
      material = builtin_material(entry, parameters);
    } catch (const std::runtime_error& refused) {
      EXPECT_LT(share, 0.5e-8) << name;
      EXPECT_NE(std::string(refused.what()).find(strength), std::string::npos) << refused.what();
      continue;
    }
    const check::Report report = check::run_battery(*material, {.effort = {.quick = true}});
    EXPECT_TRUE(report.passes()) << name << " with a strength of " << share
                                 << " E: " << (report.diagnosis.empty() ? "" : report.diagnosis[0].sentence);
  }
}

TEST(LongStrengths, PlasticModelsPass) {
  expect_right("j2_jaumann", assay_builtin_j2_jaumann, "yield_stress", {});
  expect_right("j2_multiplicative", assay_builtin_j2_multiplicative, "yield_stress", {});
  expect_right("drucker_prager", assay_builtin_drucker_prager, "cohesion", {{"friction", 0}});
  expect_right("perzyna", assay_builtin_perzyna, "yield_stress", {{"reference_rate", 1}, {"reference_stress", 1}});
}

TEST(Strengths, AConeWithoutCohesionPasses) {
  expect_right("drucker_prager", assay_builtin_drucker_prager, "cohesion", {{"friction", 0.2}});
}

TEST(LongStrengths, WhatHardensPasses) {
  for (const assay_material_entry_function entry : {assay_builtin_j2_jaumann, assay_builtin_j2_multiplicative})
    expect_right("hardening J2", entry, "yield_stress", {{"hardening_modulus", 100}});
  expect_right("hardening cone", assay_builtin_drucker_prager, "cohesion",
               {{"friction", 0}, {"hardening_modulus", 100}});
}

}  // namespace
}  // namespace assay::test_strengths
