// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_tabulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/format/csv.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_path_tabulation {
namespace {

struct Found {
  int status = -1;
  nlohmann::json result;
  std::vector<std::string> files;
};

Found tabulated(const std::string& text, std::vector<std::string> sets = {}) {
  const ScratchFolder scratch;
  scratch.write("data.csv", "t,x,y\n0,0,0\n0.5,0.01,10\n1,0.02,20\n");
  TabulateOptions options;
  options.scene = scratch.write("path.yaml", text);
  options.out = scratch / "out";
  options.sets = std::move(sets);
  options.verbosity = Verbosity::quiet;
  Found found;
  found.status = tabulate(options);
  found.result = nlohmann::json::parse(bytes_of(options.out + "/result.json"));
  for (const auto& entry : std::filesystem::directory_iterator(options.out))
    found.files.push_back(entry.path().filename().string());
  return found;
}

const std::string elastic = "material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}}\n";
const std::string plastic =
    "material: {adapter: j2_multiplicative, parameters: {E: 1.0e+3, nu: 0.3, yield_stress: 10, hardening_modulus: "
    "20}}\n";

TEST(PathTabulation, WritesTablesPicturesAndFigures) {
  const Found found = tabulated(plastic +
                                "path: {type: uniaxial_stress, control: {tau11: {type: ramp, to: 12}}}\n"
                                "variants: [{label: soft, parameters: {yield_stress: 5}}]\n"
                                "compare: {file: data.csv, y: s11, y_column: y}\n");
  EXPECT_EQ(found.status, 0);
  for (const char* name :
       {"path.csv", "path_1.csv", "path.npz", "path_stress.png", "path_compare.png", "resolved.yaml"})
    EXPECT_NE(std::ranges::find(found.files, name), found.files.end()) << name;
  EXPECT_EQ(found.result["outcome"], "completed");
  EXPECT_NEAR(found.result["last"]["e11"].get<double>(), 0.012 + 2 / 20.0, 1e-9);
  EXPECT_NEAR(found.result["last"]["plastic_strain"].get<double>(), 2 / 20.0, 1e-9);
  EXPECT_NEAR(found.result["variants"][0]["last"]["plastic_strain"].get<double>(), 7 / 20.0, 1e-9);
  EXPECT_GT(found.result["misfit"].get<double>(), 0.1);
  // work = energy + dissipation, and what is dissipated is the plastic work
  const double p = 0.1, dissipated = 10 * p + 10 * p * p;
  EXPECT_NEAR(found.result["last"]["dissipation"].get<double>(), dissipated, 1e-7);
}

TEST(LongPathTabulation, JudgesItsExpectations) {
  const std::string path = "path: {type: uniaxial_stress, control: {e11: 0.005}}\n";
  EXPECT_EQ(tabulated(elastic + path + "expect: {outcome: completed, last.e11: {between: [0.0049, 0.0051]}}\n").status,
            0);
  EXPECT_EQ(tabulated(elastic + path + "expect: {last.s11: {above: 100}}\n").status, 1);
  EXPECT_NE(refusal_of([&] { tabulated(elastic + path + "expect: {last.s44: 1}\n"); }).find("no column of path.csv"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { tabulated(elastic + path + "expect: {error.l2_max: 1}\n"); }).find("l2_max"),
            std::string::npos);
  EXPECT_NEAR(tabulated(elastic + path, {"path.control.e11=0.1"}).result["last"]["e11"].get<double>(), 0.1, 1e-12);
}

TEST(LongPathTabulation, SaysWhyAPathEnds) {
  const Found limit = tabulated(plastic + "path: {type: uniaxial_stress, control: {tau11: {type: ramp, to: 20}}}\n",
                                {"material.parameters.hardening_modulus=0"});
  EXPECT_EQ(limit.status, 1);
  EXPECT_EQ(limit.result["outcome"], "limit_load");
  const std::string reason = limit.result["reason"];
  EXPECT_NE(reason.find("limit load at t = 0.5 s, tau11 = 10"), reason.npos) << reason;
  EXPECT_NE(reason.find("e11"), reason.npos) << reason;
  const Found free = tabulated(elastic +
                                   "path: {control: {P11: 0, P12: 0, P13: 0, P21: 0, P22: 0, P23: 0, P31: 0, "
                                   "P32: 0, P33: 0, F11: 1}}\n",
                               {"path.control={P11: 0, P12: 0, P13: 0, P21: 0, P22: 0, P23: 0, P31: 0, P32: 0, "
                                "F33: 1}"});
  EXPECT_EQ(free.result["outcome"], "undetermined");
  EXPECT_NE(std::string(free.result["reason"]).find("leave a deformation free"), std::string::npos);
  const Found stopped = tabulated(
      plastic + "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 1}}, stop: {above: {e11: 0.25}}}\n");
  EXPECT_EQ(stopped.status, 0);
  EXPECT_EQ(stopped.result["reason"], "e11 above 0.25 at t = 0.25 s");
}

TEST(LongPathTabulation, MeasuresWhatIncrementsCost) {
  const Found found = tabulated(plastic +
                                "path: {control: {e11: {type: table, times: [0, 1, 2], values: [0, 0.04, 0.04]}, e12: "
                                "{type: table, times: [0, 1, 2], values: [0, 0, 0.05]}, s22: 0, s33: 0}}\n"
                                "increments: [8, 16, 32, 64]\n"
                                "iso_error: {from: [0.01, -0.003], unit: 0.01, reach: 6, points: 3}\n");
  EXPECT_EQ(found.status, 0);
  const auto& rows = found.result["increments"];
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_NEAR(rows[3]["order"].get<double>(), 2, 0.2);  // the mean normal of Rice and Tracey
  EXPECT_LT(rows[3]["error"].get<double>(), 0.2 * rows[0]["error"].get<double>());
  EXPECT_GT(found.result["iso_error"]["largest"].get<double>(), 0.05);
  EXPECT_LT(found.result["iso_error"]["largest"].get<double>(), 0.2);
}

/// Three periods between two rows: each half and third of a step meets the same value.
TEST(LongPathTabulation, TakesIncrementsFromTheCommandLine) {
  const ScratchFolder scratch;
  TabulateOptions options;
  options.scene = scratch.write(
      "path.yaml", plastic +
                       "path:\n  control:\n    e11: {type: table, times: [0, 1, 2], values: [0, 0.05, 0.05]}\n"
                       "    e12: {type: table, times: [0, 1, 2], values: [0, 0, 0.05]}\n    s22: 0\n    s33: 0\n"
                       "expect: {finest.order: {above: 1.8}}\n");
  options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  options.increments = "16,32,64";
  EXPECT_EQ(tabulate(options), 0);
  const auto found = nlohmann::json::parse(bytes_of(options.out + "/result.json"));
  ASSERT_EQ(found["increments"].size(), 3u);
  EXPECT_EQ(found["increments"][2]["increments"], 64);
  EXPECT_TRUE(std::filesystem::exists(options.out + "/increments_cost.png"));
  for (const char* wrong : {"8,4", "8,,16", "a", "0,1", "1.5"}) {
    options.increments = wrong;
    EXPECT_NE(refusal_of([&] { tabulate(options); }).find("--increments: must be whole numbers that ascend"),
              std::string::npos)
        << wrong;
  }
}

TEST(LongPathTabulation, PrescribesTheVolume) {
  const Found undrained =
      tabulated(elastic + "path: {type: undrained_triaxial, control: {F11: {type: ramp, to: 0.9}}}\n");
  EXPECT_EQ(undrained.status, 0);
  EXPECT_NEAR(undrained.result["last"]["J"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(undrained.result["last"]["F22"].get<double>(), 1 / std::sqrt(0.9), 1e-10);
  // uniaxial stress driven by J: lambda ln J + mu (l2^2 - 1) = 0, and lambda / mu = 2 nu / (1 - 2 nu) = 1.5
  for (const char* row :
       {"J: {type: ramp, to: 1.05}", "lnJ: {type: ramp, to: 0.04879016416943201}",
        "lnJ: {type: ramp, to: 0.04879016416943201}, F12: 0", "detF: {type: ramp, to: 1.05}, L12: 0"}) {
    const Found found = tabulated(elastic + "path: {type: uniaxial_stress, control: {" + row + "}}\n");
    EXPECT_EQ(found.status, 0) << row;
    EXPECT_NEAR(found.result["last"]["F22"].get<double>(), std::sqrt(1 - 1.5 * std::log(1.05)), 1e-10) << row;
  }
  EXPECT_NE(refusal_of([&] { tabulated(elastic + "path: {control: {L11 + lnJ: 0.1}}\n"); }).find("with J or with lnJ"),
            std::string::npos);
}

TEST(LongPathTabulation, JudgesVariants) {
  const std::string path =
      "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.05}}}\n"
      "variants: [{label: soft, parameters: {yield_stress: 5}}, {label: same}]\n";
  EXPECT_EQ(tabulated(plastic + path +
                      "expect: {variants.soft.last.plastic_strain: {above: 0.04}, variants.soft.outcome: completed,\n"
                      "         variants.same.difference: 0, variants.soft.difference: {between: [0.4, 0.5]}}\n")
                .status,
            0);
  EXPECT_EQ(tabulated(plastic + path + "expect: {variants.soft.last.plastic_strain: {below: 0.04}}\n").status, 1);
  EXPECT_NE(refusal_of([&] { tabulated(plastic + path + "expect: {variants.hard.error: 1}\n"); }).find("variants.hard"),
            std::string::npos);
  // a variant that does not come to its end
  const std::string load =
      "path: {type: uniaxial_stress, control: {tau11: {type: ramp, to: 12}}}\n"
      "variants: [{label: ideal, parameters: {hardening_modulus: 0}}]\n";
  EXPECT_EQ(tabulated(plastic + load).status, 1);
  EXPECT_EQ(tabulated(plastic + load + "expect: {variants.ideal.outcome: limit_load}\n").status, 0);
}

TEST(PathTabulation, RefusesLabelsThatNameNothing) {
  const std::string path = "path: {type: uniaxial_stress, control: {e11: 0.01}}\n";
  EXPECT_NE(
      refusal_of([&] { tabulated(elastic + path + "variants: [{label: \"a\\nb\"}]\n"); }).find("one line of text"),
      std::string::npos);
  EXPECT_NE(refusal_of([&] {
              tabulated(elastic + path + "variants: [{label: a}, {label: a}]\n");
            }).find("variants[1].label: 'a' is the label of another variant"),
            std::string::npos);
}

/// Consolidated and then sheared: Drucker-Prager peaks at q (1/sqrt 3 - friction) = k + 3 friction p.
TEST(LongPathTabulation, GoesOnFromStageToStage) {
  const std::string soil =
      "material: {adapter: drucker_prager, parameters: {E: 1.0e+7, nu: 0.3, cohesion: 1000, friction: 0.2, dilatancy: "
      "0.1}}\n";
  const Found found =
      tabulated(soil +
                "stages:\n"
                "  - {type: isotropic, control: {tau11: {type: ramp, to: -1.0e+4}}}\n"
                "  - {type: triaxial, end: 2, control: {e11: {type: ramp, to: -0.05}, tau22: -1.0e+4, "
                "tau33: -1.0e+4}, stop: {below: {e11: -0.02}}}\n"
                "  - {type: general, control: {L11: -0.01, s22 - s33: 0, lnJ: {type: ramp, to: -0.001}}}\n");
  EXPECT_EQ(found.status, 0) << found.result["reason"];
  EXPECT_EQ(found.result["outcome"], "completed");
  const Found short_one = tabulated(soil +
                                    "stages:\n"
                                    "  - {type: isotropic, control: {tau11: {type: ramp, to: -1.0e+4}}}\n"
                                    "  - {type: triaxial, end: 2, control: {e11: {type: ramp, to: -0.05}, tau22: "
                                    "-1.0e+4, tau33: -1.0e+4}}\n");
  EXPECT_NEAR(short_one.result["last"]["t"].get<double>(), 3, 1e-12);
  const double q = (1000 + 3 * 0.2 * 1e4) / (1 / std::sqrt(3) - 0.2);
  EXPECT_NEAR(short_one.result["last"]["tau11"].get<double>(), -1e4 - q, 1e-6 * q);
  EXPECT_NEAR(short_one.result["last"]["tau22"].get<double>(), -1e4, 1e-6);
  // an elastic point does not know where it rested
  const std::string one = "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.03}}}\n";
  const std::string two =
      "stages:\n  - {type: uniaxial_stress, control: {F11: {type: ramp, to: 1.01}}}\n"
      "  - {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.03}}}\n";
  EXPECT_NEAR(tabulated(elastic + one).result["last"]["s11"].get<double>(),
              tabulated(elastic + two).result["last"]["s11"].get<double>(), 1e-8);
}

TEST(PathTabulation, RefusesStagesThatDoNotFollow) {
  const std::string first = "  - {type: simple_shear, control: {F12: {type: ramp, to: 0.1}}}\n";
  EXPECT_NE(refusal_of([&] {
              tabulated(elastic + "stages:\n" + first + "  - {control: {e11: 0.1}}\n");
            }).find("stages[1].control: is controlled by e"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { tabulated(elastic + "stages: []\n"); }).find("must be a list of paths"),
            std::string::npos);
  EXPECT_NE(
      refusal_of([&] {
        tabulated(elastic + "stages:\n" + first + "  - {control: {F11: 1}, initial_stress: [1, 1, 1, 0, 0, 0]}\n");
      }).find("stages[1]: begins with the stress"),
      std::string::npos);
  EXPECT_NE(refusal_of([&] {
              tabulated(elastic + "stages:\n" + first + "increments: [1, 2]\n");
            }).find("cannot be combined with stages"),
            std::string::npos);
}

/// One line, and nothing is written: exit status 2.
TEST(PathTabulation, RefusesAnInitialStressThatIsNotCarried) {
  EXPECT_NE(refusal_of([&] {
              tabulated(elastic + "path: {control: {e11: 0.1}, initial_stress: [-1, -1, -1, 0, 0, 0]}\n");
            }).find("path.yaml:2:45: path.initial_stress: material 'neo_hookean' does not carry it"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] {
              tabulated(
                  "material: {adapter: neo_hookean, initial_stress: [1, 1, 1, 0, 0, 0], parameters: {E: 1}}\n"
                  "path: {control: {e11: 0.1}}\n");
            }).find("is path.initial_stress where a point takes a path"),
            std::string::npos);
}

TEST(LongPathTabulation, SeesASineThatFitsItsRows) {
  const Found found = tabulated(plastic +
                                "path: {type: uniaxial_stress, rows: 10, control: {e11: {type: sine, amplitude: "
                                "0.03, period: 0.03333333333333333}}}\n");
  EXPECT_EQ(found.status, 0);
  EXPECT_GT(found.result["last"]["plastic_strain"].get<double>(), 0.9);
}

TEST(LongPathTabulation, StopsAtRestAndWhereItsCallsEnd) {
  const std::string ramp = "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 1}}";
  const Found rest = tabulated(plastic + ramp + ", stop: {above: {e11: -1}}}\n");
  EXPECT_EQ(rest.result["t"], 0);
  const Found few = tabulated(plastic + ramp + "}\n", {"path.calls=100"});
  EXPECT_EQ(few.result["outcome"], "out_of_calls");
  EXPECT_EQ(few.status, 1);
}

/// Of measured values on the path, the last one too; what lies beyond it is told.
TEST(LongPathTabulation, CountsMeasuredValues) {
  const std::string text = elastic +
                           "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.02}}}\n"
                           "compare: {file: data.csv, x: e11, y: s11, x_column: x, y_column: y}\n";
  const Found whole = tabulated(text), part = tabulated(text, {"path.control.e11={type: ramp, to: 0.015}"});
  EXPECT_TRUE(whole.result["warnings"].empty());
  EXPECT_LT(whole.result["misfit"].get<double>(), 0.05);
  EXPECT_EQ(part.result["warnings"][0], "misfit: 1 of 3 measured values lie beyond the path");
}

/// Another kind of file is named with its verb, and options that belong elsewhere are refused.
TEST(PathTabulation, RefusesWhatBelongsElsewhere) {
  const ScratchFolder scratch;
  RunOptions run_options;
  run_options.scene = scratch.write("path.yaml", elastic + "path: {control: {e11: 0}}\n");
  run_options.out = scratch / "out";
  const std::string said = refusal_of([&] { run(run_options); });
  EXPECT_NE(said.find("a path of the point driver"), said.npos) << said;
  EXPECT_NE(said.find("assay tabulate"), said.npos) << said;
  TabulateOptions options;
  static_cast<SceneOptions&>(options) = run_options;
  options.defines = {"library=a"};
  EXPECT_NE(refusal_of([&] { tabulate(options); }).find("--define"), std::string::npos);
}

/// At a jump two rows stand at one time: each is compared with its like.
TEST(LongPathTabulation, AVariantThatIsTheSameDiffersByNothing) {
  const std::string same = "variants: [{label: same, parameters: {nu: 0.3}}]\n";
  for (const char* control :
       {"tau11: 12", "e11: {type: table, times: [0, 0.5, 0.5, 1], values: [0, 0.01, 0.02, 0.03]}"}) {
    const Found found = tabulated(plastic + "path: {type: uniaxial_stress, control: {" + control + "}}\n" + same);
    EXPECT_EQ(found.result["variants"][0]["difference"].get<double>(), 0) << control;
  }
}

/// "elast." ends with "last.": a label is no prefix of a column.
TEST(LongPathTabulation, LabelsMayHoldTheWordsOfKeys) {
  const Found found = tabulated(plastic +
                                "path: {type: uniaxial_stress, control: {e11: {type: ramp, to: 0.02}}}\n"
                                "variants: [{label: elast, parameters: {yield_stress: 5}}]\n"
                                "compare: {file: data.csv, y: s11, y_column: y}\n"
                                "expect: {variants.elast.misfit: {below: 10}, variants.elast.last.s11: {above: 1}}\n");
  EXPECT_EQ(found.status, 0);
}

/// Stress that is prescribed is met, whatever the increments err by: the deformation tells.
TEST(LongPathTabulation, IncrementsUnderStressErrInDeformation) {
  const std::string back =
      "material: {adapter: j2_jaumann, parameters: {E: 1.0e+3, nu: 0.3, yield_stress: 10, hardening_modulus: 20, "
      "kinematic_modulus: 30}}\n";
  const Found found =
      tabulated(back +
                "path: {type: torsion, control: {s12: {type: table, times: [0, 1, 2], values: [0, 8, 8]},"
                " s11: {type: table, times: [0, 1, 2], values: [0, 0, 8]}}}\nincrements: [4, 8, 16]\n");
  const auto& rows = found.result["increments"];
  ASSERT_EQ(rows.size(), 3u);
  for (const auto& row : rows) {
    EXPECT_LT(row["stress"].get<double>(), 1e-9);
    EXPECT_GT(row["error"].get<double>(), 1e-7);
    EXPECT_EQ(row["error"], row["deformation"]);
  }
  EXPECT_GT(rows[2]["order"].get<double>(), 0.8);
}

/// The path is known at the times at which it is compared, however few its rows are.
TEST(LongPathTabulation, AMisfitDoesNotDependOnRows) {
  const std::string rest =
      ", control: {e11: {type: sine, amplitude: 0.01, period: 0.4}}}\ncompare: {file: data.csv, y: s11, y_column: y}\n";
  const double few = tabulated(elastic + "path: {type: uniaxial_stress, rows: 1" + rest).result["misfit"];
  const double many = tabulated(elastic + "path: {type: uniaxial_stress, rows: 500" + rest).result["misfit"];
  EXPECT_NEAR(few, many, 1e-9);
}

/// One unknown deformation: its stiffness vanishes at the largest load.
TEST(LongPathTabulation, ALimitLoadOfOneUnknownIsNamed) {
  const Found found = tabulated(
      "material: {adapter: neo_hookean, parameters: {E: 3.0e+6, nu: 0.2}}\n"
      "path: {type: isotropic, control: {s11: {type: ramp, to: 3.0e+6}}}\n");
  EXPECT_EQ(found.result["outcome"], "limit_load");
  EXPECT_NEAR(found.result["last"]["s11"].get<double>(), 765015, 1);
}

/// Two functions with knots that rounding has made two: no row follows another by less.
TEST(LongPathTabulation, NoTwoRowsStandWithinRounding) {
  const Found found = tabulated(
      "material: {adapter: compressible_fluid, parameters: {bulk_modulus: 1.0e+3, viscosity: 1.0}}\n"
      "path: {control: {L12: {type: sine, amplitude: 1.0, period: 3.3}, L11: {type: sine, amplitude: 0.1, period: "
      "2.31}}, end: 3.3}\nexpect: {largest.s12: {below: 1.001}}\n");
  EXPECT_EQ(found.status, 0);
}

}  // namespace
}  // namespace assay::drivers::test_path_tabulation
