// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study.hpp"

#include <gtest/gtest.h>

#include <set>

#include <filesystem>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/study/study_text_fixture.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_plan {
namespace {

Plan planned_of(const StudyFolder& folder, const std::string& text) { return plan_of(folder.read(text)); }

std::string plan_refusal(const StudyFolder& folder, const std::string& text) {
  const Study study = folder.read(text);
  return folder.shortened_line(refusal_of([&] { plan_of(study); }));
}

Scene scene_in(const PlannedCase& one) { return scene_from_text(one.yaml, "case.yaml"); }

const std::string methods_on_grids =
    "axes:\n"
    "  method: {CPDI: {method.basis: cpdi}, uGIMP: {method.basis: ugimp}}\n"
    "  grid.spacing: [0.75, 0.5]\n"
    "refine: grid.spacing\n";

TEST(Plan, CasesHaveNumbersLabelsAndSeries) {
  const Plan plan = planned_of(StudyFolder(), methods_on_grids);
  ASSERT_EQ(plan.cases.size(), 4u);
  const char* labels[] = {"CPDI, grid.spacing=0.75", "CPDI, grid.spacing=0.5", "uGIMP, grid.spacing=0.75",
                          "uGIMP, grid.spacing=0.5"};
  for (std::size_t i = 0; i < 4; ++i) {
    const PlannedCase& one = plan.cases[i];
    EXPECT_EQ(one.number, i + 1);
    EXPECT_EQ(one.label, labels[i]);
    EXPECT_EQ(one.series, i < 2 ? "CPDI" : "uGIMP");
    EXPECT_EQ(one.resolution, i % 2 == 0 ? 0.75 : 0.5);
    EXPECT_EQ(one.threads, 1);
    EXPECT_TRUE(one.timed);
    EXPECT_FALSE(one.base);
    EXPECT_EQ(one.invalid, "");
    EXPECT_EQ(one.key.size(), 32u);
    EXPECT_EQ(one.key.find_first_not_of("0123456789abcdef"), std::string::npos);
    const Scene scene = scene_in(one);
    EXPECT_EQ(scene.grid.value().spacing, i % 2 == 0 ? 0.75 : 0.5);
    EXPECT_EQ(scene.method.value().basis, i < 2 ? mpm::Basis::cpdi : mpm::Basis::ugimp);
  }
  EXPECT_EQ(plan.study.axes.size(), 2u);
}

TEST(Plan, CasesThatSayNothingAreNotApplicable) {
  const StudyFolder folder;
  const std::string no = "not_applicable: [{where: {method: CPDI, grid.spacing: 0.5}, because: it says nothing}]\n";
  const Plan plan = planned_of(folder, methods_on_grids + no);
  ASSERT_EQ(plan.cases.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(plan.cases[i].invalid, i == 1 ? "it says nothing" : "");
    EXPECT_EQ(plan.cases[i].timed, i != 1);
  }
  const auto said = [&](const std::string& text) {
    return folder.shortened_line(refusal_of([&] { folder.read(methods_on_grids + text); }));
  };
  EXPECT_EQ(said("not_applicable: [{where: {method: CPDI}}]\n"),
            "study.yaml:6:18: not_applicable[0].because: required and not given");
}

TEST(Plan, ASeriesWithoutOtherAxesIsAll) {
  const StudyFolder folder;
  const Plan refined = planned_of(folder, "axes: {grid.spacing: [0.75, 0.5]}\nrefine: grid.spacing\n");
  EXPECT_EQ(refined.cases[0].series, "all");
  EXPECT_EQ(refined.cases[0].label, "grid.spacing=0.75");
  const Plan levels = planned_of(
      folder,
      "axes: {cells: {4: {grid.spacing: 0.75}, 6: {grid.spacing: 0.5}}, threads: [1, 2]}\nrefine: grid.spacing\n");
  EXPECT_EQ(levels.cases[3].label, "6, threads=2");
  EXPECT_EQ(levels.cases[3].series, "threads=2");
  EXPECT_EQ(levels.cases[3].resolution, 0.5);
  const Plan none = planned_of(folder, "axes: {grid.spacing: [0.75]}\n");
  EXPECT_EQ(none.cases[0].series, "grid.spacing=0.75");
  EXPECT_FALSE(none.cases[0].resolution);
}

TEST(Plan, ALabelIsOneLine) {
  const Plan plan = planned_of(StudyFolder(), "axes: {method: {\"a\\nb\\tc\\e[31m\": {}}}\n");
  EXPECT_EQ(plan.cases[0].label, "a b c<U+001B>[31m");
  EXPECT_EQ(plan.cases[0].series, "a b c<U+001B>[31m");
}

TEST(Plan, ThreadsAreAnAxisOrSetOfAll) {
  const StudyFolder folder;
  const Plan axis = planned_of(folder, "axes: {threads: [1, 3]}\n");
  EXPECT_EQ(axis.cases[0].threads, 1);
  EXPECT_EQ(axis.cases[1].threads, 3);
  EXPECT_EQ(axis.cases[0].yaml, axis.cases[1].yaml);
  EXPECT_NE(axis.cases[0].key, axis.cases[1].key);
  const Plan set = planned_of(folder, "set: {threads: 2}\naxes: {how: {as set: {}, alone: {threads: 1}}}\n");
  EXPECT_EQ(set.cases[0].threads, 2);
  EXPECT_EQ(set.cases[1].threads, 1);
  EXPECT_EQ(plan_refusal(folder, "axes: {threads: [1, 0]}\n"),
            "study.yaml:2:21: threads: must be from 1 to 4096, found '0' (case: threads=0)");
  EXPECT_EQ(plan_refusal(folder, "axes: {threads: [two]}\n"),
            "study.yaml:2:18: threads: must be a whole number, found 'two' (case: threads=two)");
  EXPECT_EQ(plan_refusal(folder, "axes: {threads: [1]}\nrefine: threads\n"),
            "study.yaml:3:9: refine: 'threads' is no number of the scene");
}

TEST(Plan, WhatIsSetHoldsInAllCasesUnlessAnAxisSetsIt) {
  const Plan plan = planned_of(StudyFolder(),
                               "set: {method.courant: 0.3, time.end: 0.5, output.particles: 4}\n"
                               "axes: {how: {a: {}, b: {method.courant: 0.2}}}\n");
  const Scene a = scene_in(plan.cases[0]), b = scene_in(plan.cases[1]);
  EXPECT_EQ(a.method.value().courant, 0.3);
  EXPECT_EQ(b.method.value().courant, 0.2);
  EXPECT_EQ(a.time.end, 0.5);
  EXPECT_EQ(b.time.end, 0.5);
  EXPECT_EQ(a.output.particles, 4) << "over what a study leaves";
}

TEST(Plan, ACaseLeavesLittleAndExpectsNothing) {
  const Scene scene = scene_in(planned_of(StudyFolder(), "axes: {grid.spacing: [0.75]}\n").cases[0]);
  EXPECT_EQ(scene.output.particles, 0);
  EXPECT_FALSE(scene.output.report);
  EXPECT_TRUE(scene.expect.empty()) << "the scene's expectations are of its own values";
}

TEST(Plan, ParticleStepsAreExpected) {
  const Plan plan = planned_of(StudyFolder(), "set: {time.step: 0.01}\naxes: {time.end: [0.5, 1]}\n");
  EXPECT_EQ(plan.cases[0].particle_steps, 48 * 50) << "of 4 x 4 cells of 2 x 2 particles 16 are held";
  EXPECT_EQ(plan.cases[1].particle_steps, 48 * 100);
}

TEST(Plan, BadValuesAreToldWhereTheStudySetsThem) {
  const StudyFolder folder;
  EXPECT_EQ(plan_refusal(folder, "axes:\n  grid.spacing: [0.5,\n    -1]\n"),
            "study.yaml:4:5: grid.spacing: must be greater than 0, found '-1' (case: grid.spacing=-1)");
  EXPECT_TRUE(plan_refusal(folder, "axes: {method: {a: {method.basis: cpd}}}\n")
                  .starts_with("study.yaml:2:35: method.basis: unknown value 'cpd' (nearest: cpdi); known: "));
  EXPECT_TRUE(plan_refusal(folder, "set: {time.end: soon}\naxes: {grid.spacing: [0.5]}\n")
                  .starts_with("study.yaml:2:17: time.end: must be a number, found 'soon'"));
  EXPECT_TRUE(plan_refusal(folder, "axes: {time.end: {from: -3, to: -1}}\nsampling: {latin_hypercube: 2}\n")
                  .starts_with("study.yaml:2:8: time.end: must be greater than 0, found '-"));
  EXPECT_TRUE(plan_refusal(folder, "axes: {material.parameters.nu: [0.7]}\n").starts_with("study.yaml:2:33: "));
  EXPECT_TRUE(plan_refusal(folder, "axes: {body: [3]}\n").starts_with("study.yaml:2:15: body: must be a map"));
  EXPECT_TRUE(plan_refusal(folder, "axes: {method.basis: [ugimp]}\nrefine: method.basis\n")
                  .starts_with("study.yaml:3:9: refine: 'method.basis' is no number of the scene"));
}

TEST(Plan, FaultsOfTheSceneAreToldThere) {
  const StudyFolder folder;
  folder.scratch().write("s.yaml", std::string(small_scene) + "time: {end: never}\n");
  EXPECT_EQ(plan_refusal(folder, "axes: {grid.spacing: [0.75]}\n"),
            "s.yaml:8:13: time.end: must be a number, found 'never' (case: grid.spacing=0.75)");
  folder.scratch().write("s.yaml", "motion: [\n");
  EXPECT_TRUE(plan_refusal(folder, "axes: {grid.spacing: [0.75]}\n").starts_with("s.yaml:1:9: "));
  folder.scratch().write("s.yaml",
                         "motion: {type: vortex}\nmaterial: {adapter: neo_hookean, parameters: {E: 1}, "
                         "density: 1}\n");
  EXPECT_EQ(plan_refusal(folder, "axes: {material.density: [1]}\n"),
            "study.yaml:1:8: scene: has no method: there is nothing to run (case: material.density=1)");
}

TEST(Plan, ASceneThatStandsTwiceIsTimedIfOneOfThemIs) {
  const StudyFolder folder;
  const Plan plan = planned_of(folder, "axes: {grid.spacing: [0.25], m: {A: {}, B: {}}}\ntiming: {where: {m: B}}\n");
  ASSERT_EQ(plan.cases.size(), 2U);
  EXPECT_EQ(plan.cases[0].key, plan.cases[1].key);
  EXPECT_TRUE(plan.cases[0].timed && plan.cases[1].timed);
}

TEST(Plan, LabelsOfDifferentCasesDiffer) {
  const StudyFolder folder;
  const Plan plan = planned_of(folder,
                               "axes: {m: {'a, b': {method.basis: cpdi}, a: {method.basis: linear}}, "
                               "n: {c: {method.transfer: flip}, 'b, c': {method.transfer: pic}}, "
                               "grid.spacing: [0.25]}\nrefine: grid.spacing\n");
  std::set<std::string> series;
  for (const PlannedCase& one : plan.cases) series.insert(one.series);
  EXPECT_EQ(series.size(), 4U);
  EXPECT_TRUE(series.contains("\"a, b\", c"));
}

TEST(Plan, CasesThatCannotBeAreSkippedWhereThatIsAsked) {
  const StudyFolder folder;
  const std::string text = "axes: {grid.spacing: [0.75, -1, 0.5]}\nrefine: grid.spacing\n";
  EXPECT_EQ(plan_refusal(folder, text),
            "study.yaml:2:29: grid.spacing: must be greater than 0, found '-1' (case: grid.spacing=-1)");
  const Plan plan = planned_of(folder, text + "invalid: skip\nbudget: {time: {method.courant: 0.1}}\n");
  ASSERT_EQ(plan.cases.size(), 5u) << "nothing is divided of a case that cannot be";
  EXPECT_EQ(folder.shortened_line(plan.cases[1].invalid),
            "study.yaml:2:29: grid.spacing: must be greater than 0, found '-1'");
  EXPECT_EQ(plan.cases[1].key, "");
  EXPECT_EQ(plan.cases[1].yaml, "");
  EXPECT_EQ(plan.cases[1].number, 2u);
  EXPECT_FALSE(plan.cases[1].timed) << "it does not run";
  EXPECT_EQ(plan.cases[2].invalid, "");
  EXPECT_EQ(plan.cases[3].base, 0u);
  EXPECT_EQ(plan.cases[4].base, 2u);
}

TEST(Plan, FaultsThatEveryCaseHasAreNotSkipped) {
  const StudyFolder folder;
  EXPECT_TRUE(plan_refusal(folder, "axes: {method.basis: [ugimp]}\nrefine: method.basis\ninvalid: skip\n")
                  .starts_with("study.yaml:3:9: refine: 'method.basis' is no number of the scene"));
  EXPECT_EQ(plan_refusal(folder, "axes: {grid.spacing: [-1, -2]}\ninvalid: skip\n"),
            "study.yaml: no case can be; the first: study.yaml:2:23: grid.spacing: must be greater than 0, found '-1'");
}

TEST(Plan, TimedAreTheCasesThatTheStudySelects) {
  const StudyFolder folder;
  const Plan some =
      planned_of(folder, methods_on_grids + "timing: {where: {method: CPDI, grid.spacing: {below: 0.6}}}\n");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(some.cases[i].timed, i == 1) << i;
  for (const PlannedCase& one : planned_of(folder, methods_on_grids + "timing: none\n").cases) EXPECT_FALSE(one.timed);
}

TEST(Plan, TheBudgetAddsACaseForEachSource) {
  const Plan plan = planned_of(StudyFolder(), methods_on_grids +
                                                  "budget:\n"
                                                  "  of: {method: uGIMP}\n"
                                                  "  space: {grid.spacing: 0.25}\n"
                                                  "  time: {method.courant: 0.1, threads: 2}\n");
  ASSERT_EQ(plan.cases.size(), 8u);
  for (std::size_t i = 4; i < 8; ++i) {
    const PlannedCase& one = plan.cases[i];
    const PlannedCase& base = plan.cases[2 + (i - 4) / 2];
    EXPECT_EQ(one.number, i + 1);
    EXPECT_EQ(one.base, 2 + (i - 4) / 2);
    EXPECT_EQ(one.source, (i - 4) % 2);
    EXPECT_EQ(one.label, base.label + ((i - 4) % 2 == 0 ? ", space refined" : ", time refined"));
    EXPECT_FALSE(one.timed);
    const Scene scene = scene_in(one), of_base = scene_in(base);
    EXPECT_EQ(scene.method.value().basis, mpm::Basis::ugimp);
    if (i % 2 == 0) {
      EXPECT_EQ(scene.grid.value().spacing, 0.25);
      EXPECT_EQ(scene.method.value().courant, of_base.method.value().courant);
    } else {
      EXPECT_EQ(scene.grid.value().spacing, of_base.grid.value().spacing);
      EXPECT_EQ(scene.method.value().courant, 0.1);
      EXPECT_EQ(one.threads, 2);
    }
  }
  EXPECT_EQ(plan_refusal(StudyFolder(), methods_on_grids + "budget: {space: {grid.spacing: -1}}\n"),
            "study.yaml:6:32: grid.spacing: must be greater than 0, found '-1' (case: CPDI, grid.spacing=0.75, space "
            "refined)");
}

TEST(Plan, RelativePathsCountFromTheFileInWhichTheyStand) {
  namespace fs = std::filesystem;
  const StudyFolder folder;
  fs::create_directories(folder.scratch() / "studies");
  fs::create_directories(folder.scratch() / "scenes");
  fs::copy(built("materials/libneo_hookean.so"), folder.scratch() / "studies/mine.so");
  fs::copy(built("materials/libneo_hookean.so"), folder.scratch() / "scenes/theirs.so");
  std::string text = small_scene;
  text.replace(text.find("neo_hookean"), 11, "theirs.so");
  folder.scratch().write("scenes/s.yaml", text);
  const Plan plan = plan_of(study_from_text(
      "scene: ../scenes/s.yaml\naxes: {whose: {the study's: {material.adapter: mine.so}, the scene's: {}}}\n",
      folder.scratch() / "studies/study.yaml"));
  EXPECT_EQ(fs::path(scene_in(plan.cases[0]).material.adapter), fs::path(folder.scratch() / "studies/mine.so"));
  EXPECT_EQ(fs::path(scene_in(plan.cases[1]).material.adapter), fs::path(folder.scratch() / "scenes/theirs.so"));
}

TEST(Plan, TellsItsProgress) {
  std::vector<double> shares;
  plan_of(StudyFolder().read(methods_on_grids), [&](double share) { shares.push_back(share); });
  EXPECT_EQ(shares, (std::vector<double>{0.25, 0.5, 0.75, 1}));
}

}  // namespace
}  // namespace assay::drivers::test_plan
