// SPDX-License-Identifier: BSD-3-Clause
// What every built-in model must satisfy; a model without a line in `parameters_of` fails here.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/check/battery.hpp"
#include "tests/adapters/models/properties.hpp"

namespace assay::model_tests::test_all_models {
namespace {

struct Variant {
  std::string model;
  Parameters parameters;
};

Parameters joined(Parameters a, const Parameters& b) {
  a.insert(b.begin(), b.end());
  return a;
}

void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.model; }

/// Parameters at which the samples of `properties.cpp` load, yield, unload; more than one set where there are options.
std::vector<Variant> variants() {
  const Parameters elastic{{"E", 1000}, {"nu", 0.3}}, j2 = joined(elastic, {{"yield_stress", 20}});
  const Parameters voce{{"hardening_modulus", 30}, {"saturation_stress", 15}, {"saturation_rate", 12}};
  const Parameters viscous{{"reference_rate", 0.5}, {"reference_stress", 30}, {"exponent", 3}};
  return {{"neo_hookean", elastic},
          {"saint_venant_kirchhoff", elastic},
          {"mooney_rivlin", {{"c10", 120}, {"c01", 40}, {"bulk_modulus", 800}}},
          {"hypoelastic_jaumann", elastic},
          {"hypoelastic_green_naghdi", elastic},
          {"hypoelastic_logarithmic", elastic},
          {"j2_jaumann", j2},
          {"j2_jaumann", joined(j2, voce)},
          {"j2_jaumann", joined(joined(j2, voce), {{"kinematic_modulus", 80}})},
          {"j2_multiplicative", j2},
          {"j2_multiplicative", joined(j2, voce)},
          {"j2_multiplicative", joined(joined(j2, voce), {{"kinematic_modulus", 80}})},
          {"zener", joined(elastic, {{"viscous_ratio", 1.5}, {"relaxation_time", 0.3}})},
          {"norton", joined(elastic, viscous)},
          {"perzyna", joined(joined(j2, viscous), {{"hardening_modulus", 30}})},
          {"drucker_prager", joined(elastic, {{"cohesion", 15}, {"friction", 0.2}, {"dilatancy", 0.1}})},
          {"drucker_prager",
           joined(elastic, {{"cohesion", 15}, {"friction", 0.2}, {"dilatancy", 0.1}, {"hardening_modulus", 20}})},
          {"damage", joined(elastic, {{"kappa_0", 0.5}, {"kappa_f", 20}})},
          {"orthotropic_cylindrical",
           {{"E_r", 1000},
            {"E_t", 1500},
            {"E_z", 700},
            {"nu_rt", 0.2},
            {"nu_rz", 0.25},
            {"nu_tz", 0.3},
            {"G_rt", 350},
            {"G_rz", 300},
            {"G_tz", 400}}},
          {"compressible_fluid", {{"bulk_modulus", 500}, {"exponent", 7}}},
          {"compressible_fluid", {{"bulk_modulus", 500}, {"viscosity", 3}, {"bulk_viscosity", 2}, {"exponent", 7}}}};
}

class EveryModel : public testing::TestWithParam<Variant> {
 protected:
  const Material material_ = material_of(GetParam().model, GetParam().parameters);

  bool has(const char* extension) const {
    return material_.table().extension && material_.table().extension(extension) != nullptr;
  }
};

void expect_below(const Measured& measured, double bound, bool offered) {
  EXPECT_EQ(measured.visited > 0, offered);
  EXPECT_LE(measured.error, bound);
  testing::Test::RecordProperty("error", std::to_string(measured.error));
}

TEST_P(EveryModel, RateIsTheDerivativeOfIncrements) {
  expect_below(rate_error(material_), 2e-5, has(ASSAY_EXTENSION_RATE));
}

TEST_P(EveryModel, TangentIsTheDerivativeOfUpdate) {
  expect_below(tangent_error(material_), 1e-6, has(ASSAY_EXTENSION_TANGENT));
}

TEST_P(EveryModel, IsExactlyObjective) { expect_below(objectivity_error(material_), 1e-11, true); }

TEST_P(EveryModel, StressIsTheDerivativeOfItsEnergy) {
  expect_below(energy_error(material_), 1e-7, has(ASSAY_EXTENSION_ENERGY));
}

TEST_P(EveryModel, CallsArePureAndBatchesArePoints) { expect_below(impurity(material_), 0, true); }

TEST_P(EveryModel, ClosedFormsAreTheIncrements) {
  const Measured measured = closed_form_error(material_);
  EXPECT_LE(measured.error, 1e-11);
  EXPECT_LE(closed_form_slope_error(material_).error, 1e-10);
  if (!has(ASSAY_EXTENSION_CLOSED_FORM)) {
    EXPECT_EQ(measured.visited, 0);
  }
}

TEST_P(EveryModel, IsFreeOfStressAtRest) { expect_below(rest_error(material_), 1e-12, true); }

TEST_P(EveryModel, TellsElasticStepsFromOthers) {
  expect_below(regime_error(material_), 0, material_.has(ASSAY_NON_SMOOTH));
}

TEST_P(EveryModel, PassesTheBattery) {
  for (const bool quick : {true, false}) {
    const check::Report report = check::run_battery(material_, {.effort = {.quick = quick}});
    for (const check::Diagnosis& d : report.diagnosis) ADD_FAILURE() << d.cause << ": " << d.sentence;
  }
}

/// At rest a sand without cohesion is at its apex, and a soft metal yields below the strain of the probes: their
/// stiffness says nothing of isotropy.
TEST(Battery, JudgesNoStiffnessOfMaterialsThatYieldAtOnce) {
  const std::pair<const char*, Parameters> cases[] = {
      {"drucker_prager", {{"E", 1e7}, {"cohesion", 0}, {"friction", 0.3}}},
      {"j2_jaumann", {{"E", 1}, {"yield_stress", 1e-7}}},
      {"j2_multiplicative", {{"E", 1}, {"yield_stress", 1e-8}}}};
  for (const auto& [name, parameters] : cases) {
    const check::Report report = check::run_battery(material_of(name, parameters));
    for (const check::Diagnosis& d : report.diagnosis) ADD_FAILURE() << name << ": " << d.cause << ": " << d.sentence;
    for (const check::TestResult& test : report.tests) {
      EXPECT_TRUE(test.id != "elasticity.shear" || test.verdict == check::Verdict::not_applicable) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(variants()),
                         [](const auto& each) { return each.param.model + "_" + std::to_string(each.index); });

TEST(AllModels, AreAllHere) {
  for (const assay_material* table : adapters::builtin_tables()) {
    const auto all = variants();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Variant& v) { return v.model == table->name; }))
        << table->name;
  }
}

}  // namespace
}  // namespace assay::model_tests::test_all_models
