// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/niemunis_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_niemunis_file {
namespace {

using Kind = NiemunisStep::Kind;

/// The only step of a path whose first step begins in line 2.
NiemunisStep step_of(const std::string& lines) {
  const NiemunisFile file = niemunis_from_text("out.txt\n" + lines, "test.inp");
  EXPECT_EQ(file.blocks.size(), 1u);
  EXPECT_EQ(file.blocks[0].steps.size(), 1u);
  return file.blocks[0].steps[0];
}

std::string refused(const std::string& lines) {
  return refusal_of([&] { niemunis_from_text("out.txt\n" + lines, "test.inp"); });
}

const std::string rest_of_six = "0 0\n0 0\n0 0\n0 0\n";

TEST(NiemunisFile, ALinearLoadPrescribesSixVariables) {
  const NiemunisStep step = step_of(
      "*LinearLoad\n100, 20 2.0 : 10 T 5.5 // remark\n*Cartesian\n"
      "1 -1.5d2 // stress 11\n0, 0.01\n\n" +
      rest_of_six);
  EXPECT_EQ(step.kind, Kind::linear);
  EXPECT_EQ(step.keyword, "*LinearLoad");
  EXPECT_EQ(step.where.line, 2);
  EXPECT_EQ(step.increments, 100);
  EXPECT_EQ(step.most_iterations, 20);
  EXPECT_EQ(step.duration, 2);
  EXPECT_EQ(step.every, 10);
  EXPECT_EQ(step.temperature_change, 5.5);
  EXPECT_EQ(step.variables, NiemunisVariables::cartesian);
  EXPECT_EQ(step.is_stress, (std::array<bool, 6>{true}));
  EXPECT_EQ(step.change, (Six{-150, 0.01}));
  EXPECT_EQ(niemunis_change(step, 0, 7, 0.5), -37.5);
  EXPECT_FALSE(step.exit.has_value());
}

TEST(NiemunisFile, NamedPathsArePathsOfVariables) {
  const auto named = [](const std::string& keyword, bool has_number) {
    return step_of(keyword + "\n10 5 1\n" + (has_number ? "-0.25\n" : ""));
  };
  using Flags = std::array<bool, 6>;
  EXPECT_EQ(named("*OedometricE1", true).is_stress, Flags{});
  EXPECT_EQ(named("*OedometricS1", true).is_stress, Flags{true});
  EXPECT_EQ(named("*TriaxialE1", true).is_stress, (Flags{false, true, true}));
  EXPECT_EQ(named("*TriaxialE1", true).change, Six{-0.25});
  EXPECT_EQ(named("*TriaxialS1", true).is_stress, (Flags{true, true, true}));
  EXPECT_EQ(named("*PureRelaxation", false).is_stress, Flags{});
  EXPECT_EQ(named("*PureCreep", false).is_stress, (Flags{true, true, true, true, true, true}));
  const NiemunisStep undrained = named("*TriaxialUEq", true);
  EXPECT_EQ(undrained.variables, NiemunisVariables::roscoe);
  EXPECT_EQ(undrained.change, (Six{0, -0.25}));
  EXPECT_EQ(undrained.is_stress, Flags{});
  EXPECT_EQ(named("*TriaxialUq", true).is_stress, (Flags{false, true}));
  EXPECT_EQ(named("*UndrainedCreep", false).is_stress, (Flags{false, true, true, true, true, true}));
}

TEST(NiemunisFile, ACirculatingLoadRunsOnInTime) {
  const NiemunisStep step =
      step_of("*CirculatingLoad\n64 5 2\n*Roscoe\n1 10 0.5 3\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n");
  EXPECT_EQ(step.kind, Kind::circulating);
  const double w = std::numbers::pi;
  EXPECT_NEAR(niemunis_change(step, 0, 3, 0.4), 10 * (std::sin(w * 3.4 + 0.5) - std::sin(w * 3 + 0.5)) + 3 * 0.2,
              1e-14);
  EXPECT_NEAR(niemunis_change(step, 0, 3, 2), 3, 1e-13);
  EXPECT_EQ(niemunis_change(step, 1, 3, 2), 0);
}

TEST(NiemunisFile, ADeformationGradientHasNineLines) {
  const NiemunisStep step = step_of("*DeformationGradient\n10 1 1\n1.1\n1\n1\n0.2 F12\n0\n0\n0\n0\n0\n");
  EXPECT_EQ(step.kind, Kind::deformation_gradient);
  EXPECT_EQ(step.gradient, (std::array<double, 9>{1.1, 1, 1, 0.2}));
}

TEST(NiemunisFile, RestrictionsAreEquations) {
  const NiemunisStep step = step_of(
      "*ObeyRestrictions\n10 5 1\n-sd1 + sd2 + 3.0*sd3 = -10 ! remark\nsd2 = 0\nsd3 - 1e-3*ed3 = 1d2\n"
      "ed4 = 0 # remark\ned5 = 0\ned6 = +0.5\n");
  EXPECT_EQ(step.kind, Kind::restricted);
  EXPECT_EQ(step.restrictions.on_stress[0], (Six{-1, 1, 3}));
  EXPECT_EQ(step.restrictions.on_strain[2], (Six{0, 0, -1e-3}));
  EXPECT_EQ(step.restrictions.right, (Six{-10, 0, 100, 0, 0, 0.5}));
}

TEST(NiemunisFile, AConditionEndsAStep) {
  const NiemunisStep step = step_of("*OedometricE1 ? -2*s1 + p - v2 > 1.5e2\n10 5 1\n0.1\n");
  ASSERT_TRUE(step.exit.has_value());
  EXPECT_EQ(step.exit->terms.size(), 3u);
  EXPECT_TRUE(niemunis_exits(*step.exit, {-90, -30, -30}, {}, {0, 70}));
  EXPECT_FALSE(niemunis_exits(*step.exit, {-90, -30, -30}, {}, {0, 90}));
  const NiemunisStep below = step_of("*OedometricE1?q<-1\n10 5 1\n0.1\n");
  EXPECT_TRUE(niemunis_exits(*below.exit, {3, 0, 1}, {}, {}));
}

TEST(NiemunisFile, RepetitionsHoldTheirSteps) {
  const NiemunisFile file = niemunis_from_text(
      "out.txt # a heading\n*PureCreep\n10 5 1\n*Repetition\n2 50\n*OedometricE1\n10 5 1\n0.1\n*OedometricE1\n10 5 1\n"
      "-0.1\n*End\nwhatever\n",
      "test.inp");
  EXPECT_EQ(file.output, "out.txt");
  EXPECT_EQ(file.heading, "a heading");
  ASSERT_EQ(file.blocks.size(), 2u);
  EXPECT_EQ(file.blocks[1].repetitions, 50);
  ASSERT_EQ(file.blocks[1].steps.size(), 2u);
  EXPECT_EQ(file.blocks[1].steps[1].change[0], -0.1);
}

TEST(NiemunisFile, AnImportedHistoryHasItsIncrements) {
  const ScratchFolder scratch;
  scratch.write("h.txt", "time e1 s2\n0 0 10\n1 1 20\n3 4 50\n");
  const std::string commons = "*Cartesian\n0 2 * -0.5\n1 3\n0 0\n0 0\n0 0\n0 0\n";
  const NiemunisFile timed =
      read_niemunis(scratch.write("a.inp", "out\n*ImportFile h.txt | 3\n100 5 0\n" + commons + "1 * 10\n"));
  const NiemunisStep& step = timed.blocks[0].steps[0];
  EXPECT_EQ(step.kind, Kind::imported);
  EXPECT_EQ(step.import.file, scratch / "h.txt");
  EXPECT_EQ(step.import.changes, (std::vector<Six>{{-0.5, 10}, {-1.5, 30}}));
  EXPECT_EQ(step.import.durations, (std::vector<double>{10, 20}));
  const NiemunisFile even = read_niemunis(scratch.write("b.inp", "out\n*ImportFile h.txt | 3\n1 5 0.25\n" + commons));
  EXPECT_EQ(even.blocks[0].steps[0].import.durations, (std::vector<double>{0.25}));
}

TEST(NiemunisFile, VariablesDoTheWorkOfTheirComponents) {
  std::mt19937 random(3);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  for (const auto variables : {NiemunisVariables::cartesian, NiemunisVariables::roscoe,
                               NiemunisVariables::roscoe_isomorph, NiemunisVariables::rendulic}) {
    const SixBySix m = niemunis_matrix(variables);
    Six stress{}, x{}, e{}, strain{};
    for (std::size_t i = 0; i < 6; ++i) stress[i] = number(), e[i] = number();
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) x[i] += m[i][j] * stress[j], strain[j] += m[i][j] * e[i];
    }
    double work = 0, same = 0;
    for (std::size_t i = 0; i < 6; ++i) work += stress[i] * strain[i], same += x[i] * e[i];
    EXPECT_NEAR(work, same, 1e-15);
    if (variables == NiemunisVariables::roscoe || variables == NiemunisVariables::cartesian) continue;
    for (std::size_t i = 0; i < 6; ++i) {
      double length = 0;
      for (std::size_t j = 0; j < 6; ++j) length += m[i][j] * m[i][j];
      EXPECT_NEAR(length, 1, 1e-15) << "a rotation";
    }
  }
}

TEST(NiemunisStart, StressTemperatureAndStateAreRead) {
  const NiemunisStart start = niemunis_start_from_text(
      "4 ntens\n-100 s1\n-50\n-50\n0\n*temperature= 30.0\n3 nstatv\n0.8 void ratio\n1d-4\n", "i");
  EXPECT_EQ(start.stress, (Six{-100, -50, -50}));
  EXPECT_EQ(start.temperature, 30);
  EXPECT_EQ(start.state, (std::vector<double>{0.8, 1e-4, 0})) << "what is missing is zero";
  EXPECT_EQ(refusal_of([] { niemunis_start_from_text("7\n", "i"); }), "i:1:1: a stress has at most 6 components");
  EXPECT_EQ(refusal_of([] { niemunis_start_from_text("2\n1\n", "i"); }),
            "i:3:1: the file ends where this is missing: component 2 of the stress");
}

TEST(NiemunisParameters, TheMaterialAndItsConstantsAreRead) {
  const NiemunisParameters parameters = niemunis_parameters_from_text("Hypo # sand\n2\n33.1 phi\n1e9\n", "p");
  EXPECT_EQ(parameters.material, "Hypo");
  EXPECT_EQ(parameters.values, (std::vector<double>{33.1, 1e9}));
  EXPECT_EQ(refusal_of([] { niemunis_parameters_from_text("m\n3\n1\n2\n", "p"); }),
            "p:5:1: the file ends where this is missing: parameter 3 of 3");
}

TEST(NiemunisDamage, WhatIsWrongIsNamedByItsLine) {
  EXPECT_TRUE(
      refused("*LinerLoad\n")
          .starts_with("test.inp:2:1: unknown keyword (nearest: *LinearLoad): '*LinerLoad'; known: *CirculatingLoad, "))
      << refused("*LinerLoad\n");
  EXPECT_TRUE(refused("10 5 1\n").starts_with("test.inp:2:1: a keyword as *LinearLoad belongs here: '10'"));
  EXPECT_EQ(refused("*RandomWalk\n"),
            "test.inp:2:1: *RandomWalk: is not served: its increments are random numbers of the driver");
  EXPECT_EQ(refused("*LinearLoad\n10 5\n"),
            "test.inp:3:1: *LinearLoad: 3 numbers are needed: increments, iterations, duration");
  EXPECT_EQ(refused("*LinearLoad\n0 5 1\n"), "test.inp:3:1: '0' is no whole number from 1");
  EXPECT_EQ(refused("*LinearLoad\n1 5 -1\n"), "test.inp:3:5: *LinearLoad: the duration must not be negative");
  EXPECT_EQ(refused("*LinearLoad\n1 5 1\n*Rosco\n"),
            "test.inp:4:1: *LinearLoad: unknown kind of variables (nearest: *Roscoe); known: *Cartesian, *Roscoe, "
            "*RoscoeIsomorph, *Rendulic");
  EXPECT_EQ(refused("*LinearLoad\n1 5 1\n*Roscoe\n2 0\n"),
            "test.inp:5:1: *LinearLoad: '2' must be 0, a strain, or 1, a stress");
  EXPECT_EQ(refused("*LinearLoad\n1 5 1\n*Roscoe\n1 x\n"), "test.inp:5:3: 'x' is no number");
  EXPECT_EQ(refused("*CirculatingLoad\n1 5 0\n"), "test.inp:2:1: *CirculatingLoad: needs a duration");
  EXPECT_EQ(refused("*OedometricE1 ? s9 > 1\n1 5 1\n0\n").substr(0, 40), "test.inp:2:17: unknown name (nearest: s1");
  EXPECT_EQ(refused("*OedometricE1 ? s1\n1 5 1\n0\n"), "test.inp:2:19: a condition needs > or <");
  EXPECT_EQ(refused("*OedometricE1 ? s1 s2 > 1\n1 5 1\n0\n"), "test.inp:2:20: a sign is missing: + or -");
  EXPECT_EQ(refused("*ObeyRestrictions\n1 5 1\nsd1 + sd2\n"), "test.inp:4:10: a restriction needs '='");
  EXPECT_EQ(refused("*Repetition\n2 3\n*PureCreep\n1 5 1\n"), "test.inp:2:1: *Repetition: has 1 of 2 steps");
  EXPECT_EQ(refused("*ImportFile h.txt\n"),
            "test.inp:2:1: *ImportFile: write *ImportFile NAME | COLUMNS, the number of columns");
  EXPECT_TRUE(refused("").starts_with("test.inp: has no step; known: "));
}

TEST(NiemunisDamage, DamagedBytesGiveOneLine) {
  const std::string whole =
      "out # h\n*LinearLoad ? -2*s1 + p > 10\n10 5 1 : 2 T 3\n*Roscoe\n1 5\n0 0\n0 0\n0 0\n0 0\n0 0\n*Repetition\n1 3\n"
      "*CirculatingLoad\n10 5 1\n*Cartesian\n1 1 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0\n*ObeyRestrictions\n"
      "10 5 1\nsd1 = 1\nsd2 = 0\nsd3 = 0\ned4 = 0\ned5 = 0\ned6 - 2*sd1 = 0\n*End\n";
  const auto expect_one_line = [](const std::string& text) {
    const std::string line = refusal_of([&] { niemunis_from_text(text, "test.inp"); });
    EXPECT_EQ(line.find('\n'), line.npos) << line;
    EXPECT_TRUE(line == "accepted" || line.starts_with("test.inp")) << line;
  };
  for (std::size_t size = 0; size <= whole.size(); ++size) expect_one_line(whole.substr(0, size));
  std::mt19937 random(11);
  for (int i = 0; i < 10000; ++i) {
    std::string text = whole;
    for (unsigned hits = 1 + random() % 4; hits > 0; --hits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text[at] = static_cast<char>(random() % 256);
      else
        text.erase(at, 1 + random() % 10);
    }
    expect_one_line(text);
    for (const auto& reader : {+[](const std::string& t) { niemunis_start_from_text(t, "test.inp"); },
                               +[](const std::string& t) { niemunis_parameters_from_text(t, "test.inp"); }})
      EXPECT_EQ(refusal_of([&] { reader(text); }).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace assay::drivers::test_niemunis_file
