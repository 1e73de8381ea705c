// SPDX-License-Identifier: BSD-3-Clause
// Models that relax in much less time than the steps of the tests take are judged in steps of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "harness/check/tests.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/check/mutants.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_own_pace {
namespace {

using check::Report;

Report quickly(const Material& material) { return check::run_battery(material, {.effort = {.quick = true}}); }

std::string said_of(const Report& report) { return report.passes() ? "" : report.diagnosis[0].sentence; }

struct Relaxing {
  const char* name;
  assay_material_entry_function entry;
  std::map<std::string, double> (*at)(double time);  ///< parameters with which it relaxes in that time [s]
};

const Relaxing relaxing[] = {
    {"zener", assay_builtin_zener,
     [](double time) {
       return std::map<std::string, double>{{"E", 1e3}, {"relaxation_time", time}};
     }},
    {"norton", assay_builtin_norton,
     [](double time) {
       return std::map<std::string, double>{
           {"E", 1e3}, {"reference_rate", 1e-3 / time}, {"reference_stress", 1}, {"exponent", 1}};
     }},
    {"perzyna", assay_builtin_perzyna, [](double time) {
       return std::map<std::string, double>{
           {"E", 1e3}, {"yield_stress", 1}, {"reference_rate", 1e-3 / time}, {"reference_stress", 1}};
     }}};

TEST(LongOwnPace, RightModelsPassHoweverFastTheyRelax) {
  for (const Relaxing& model : relaxing) {
    for (const double time : {0.01, 1e-4, 1e-6, 1e-9}) {
      const Report report = quickly(*builtin_material(model.entry, model.at(time)));
      EXPECT_TRUE(report.passes()) << model.name << " that relaxes in " << time << " s: " << said_of(report);
    }
  }
}

void expect_named(const std::function<bool(const std::string&)>& chosen) {
  constexpr double faster = 1e6;
  for (const check_tests::Subject& subject : check_tests::viscous_mutants::subjects()) {
    if (!chosen(subject.name)) continue;
    const Material& model = subject.material;
    const Report report = quickly(Material(&model.table(), model.named_parameters(), faster));
    EXPECT_EQ(report.passes(), subject.cause.empty()) << subject.name << ": " << said_of(report);
    // In steps of its own an explicit spin is seen in a stress that the body has from the beginning.
    const std::string other = subject.cause == check::causes::explicit_spin ? check::causes::initial_stress : "";
    const bool is_named =
        std::any_of(report.diagnosis.begin(), report.diagnosis.end(),
                    [&](const check::Diagnosis& each) { return each.cause == subject.cause || each.cause == other; });
    EXPECT_TRUE(is_named || subject.cause.empty()) << subject.name << ": " << said_of(report);
  }
}

TEST(OwnPace, WhatIsPlantedInOneIsNamed) {
  expect_named(
      [](const std::string& name) { return name == "unturned_overstress" || name == "overstress_kept_doubled"; });
}

TEST(LongOwnPace, WhatIsPlantedIsNamedAsInSlowOnes) {
  // The first keeps what was largest in the first of two batteries; what grows has grown beyond all bounds in a second.
  const std::set<std::string> others{"static_maximum", "swelling_liquid", "growing_overstress"};
  expect_named([&](const std::string& name) { return !others.contains(name); });
}

TEST(OwnPace, ALineSaysWhichStepsWereNotTested) {
  const Report report = quickly(*builtin_material(assay_builtin_zener, relaxing[0].at(1e-6)));
  ASSERT_TRUE(report.passes()) << said_of(report);
  EXPECT_LE(report.effort.step, 1e-5);
  EXPECT_GE(report.effort.step, 1e-7);
  const auto steps = std::find_if(report.not_tested.begin(), report.not_tested.end(),
                                  [](const std::string& part) { return part.starts_with("steps above"); });
  EXPECT_NE(steps, report.not_tested.end());
}

TEST(OwnPace, WhatDoesNotRelaxOrTakesItsTimeHasNone) {
  const auto pace = [](assay_material_entry_function entry, const std::map<std::string, double>& parameters) {
    return check::own_pace(*builtin_material(entry, parameters), Report{});
  };
  EXPECT_FALSE(pace(assay_builtin_neo_hookean, {{"E", 1e3}}));
  EXPECT_FALSE(pace(assay_builtin_zener, {{"E", 1e3}, {"relaxation_time", 1}}));
  EXPECT_FALSE(pace(assay_builtin_compressible_fluid, {{"bulk_modulus", 1e3}, {"viscosity", 1e-6}}));
}

TEST(OwnPace, AFluidAsStiffAsTheEarthsMantlePasses) {
  for (const double viscosity : {1e3, 1e9, 1e15, 1e21}) {
    const Report report = quickly(
        *builtin_material(assay_builtin_compressible_fluid, {{"bulk_modulus", 1e11}, {"viscosity", viscosity}}));
    EXPECT_TRUE(report.passes()) << viscosity << ": " << said_of(report);
  }
}

}  // namespace
}  // namespace assay::test_own_pace
