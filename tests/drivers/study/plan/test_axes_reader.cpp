// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study_reader.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/study/study_text_fixture.hpp"

namespace assay::drivers::test_axes_reader {
namespace {

/// The refusal of axes in flow style; they begin at column 7 of line 2.
std::string refused_axes(const std::string& flow, const std::string& more = {}) {
  return StudyFolder().refusal("axes: " + flow + "\n" + more);
}

std::vector<std::string> level_names(const StudyAxis& axis) {
  std::vector<std::string> names;
  for (const Level& level : axis.levels) names.push_back(level.name);
  return names;
}

const std::string of_five = "sampling: {latin_hypercube: 5}\n";

TEST(AxesReader, ValuesOfAKeyAreNamedByTheirText) {
  const Study study = StudyFolder().read(
      "axes:\n"
      "  grid.spacing: [0.05, 5.0e-1]\n"
      "  body.per_cell: [[2, 2], [3,3]]\n"
      "  motion: [{type: vortex, amplitude: {peak: 1}}, {type: vortex}]\n"
      "  threads: [1, 2]\n"
      "  grid.lower: [null, [-2, -2]]\n");
  ASSERT_EQ(study.axes.size(), 5u);
  EXPECT_EQ(level_names(study.axes[0]), (std::vector<std::string>{"0.05", "5.0e-1"}));
  EXPECT_EQ(level_names(study.axes[1]), (std::vector<std::string>{"[2, 2]", "[3, 3]"}));
  EXPECT_EQ(level_names(study.axes[2]),
            (std::vector<std::string>{"{type: vortex, amplitude: {peak: 1}}", "{type: vortex}"}));
  EXPECT_EQ(level_names(study.axes[4]), (std::vector<std::string>{"null", "[-2, -2]"}));
  for (const StudyAxis& axis : study.axes) {
    EXPECT_TRUE(axis.is_key) << axis.name;
    EXPECT_FALSE(axis.span) << axis.name;
    for (const Level& level : axis.levels) {
      ASSERT_EQ(level.settings.size(), 1u);
      EXPECT_EQ(level.settings[0].path, axis.name);
      EXPECT_EQ(flow_text(level.settings[0].value), level.name);
      EXPECT_EQ(level.settings[0].where.line, axis.where.line);
    }
  }
  EXPECT_EQ(study.axes[1].where.line, 4);
  EXPECT_EQ(study.axes[1].where.column, 3);
}

TEST(AxesReader, NamedLevelsSetAnyNumberOfKeys) {
  const Study study = StudyFolder().read(
      "axes: {material: {soft: {material.parameters.E: 1, threads: 2}, as it is: {}}, title: [a]}\n");
  const StudyAxis& axis = study.axes.at(0);
  EXPECT_FALSE(axis.is_key);
  EXPECT_EQ(level_names(axis), (std::vector<std::string>{"soft", "as it is"}));
  EXPECT_EQ(axis.levels[0].settings.size(), 2u);
  EXPECT_TRUE(axis.levels[1].settings.empty());
  EXPECT_TRUE(sets_key(axis, "material.parameters.E"));
  EXPECT_TRUE(sets_key(axis, threads_key));
  EXPECT_FALSE(sets_key(axis, "material")) << "the name is none of a key";
  EXPECT_TRUE(sets_key(study.axes.at(1), "title"));
}

TEST(AxesReader, SpansAreReadWithAHypercube) {
  const Study study = StudyFolder().read(
      "axes: {grid.spacing: {from: 0.1, to: 1, log: true}, body.seed: {from: 1, to: 9, whole: true}, time.end: {from: "
      "-1, to: 1}}\n" +
      of_five);
  const Span &h = study.axes.at(0).span.value(), &seed = study.axes.at(1).span.value();
  EXPECT_EQ(h.from, 0.1);
  EXPECT_EQ(h.to, 1);
  EXPECT_TRUE(h.logarithmic);
  EXPECT_FALSE(h.whole);
  EXPECT_FALSE(seed.logarithmic);
  EXPECT_TRUE(seed.whole);
  EXPECT_EQ(study.axes.at(2).span.value().from, -1);
  EXPECT_TRUE(study.axes.at(0).levels.empty());
}

TEST(AxesReader, BadSpansAreRefused) {
  const std::pair<const char*, const char*> spans[] = {
      {"{from: 1}", "22: axes.grid.spacing.to: required and not given"},
      {"{from: 1, to: 1}", "36: axes.grid.spacing.to: must be greater than from"},
      {"{from: 2, to: 1}", "36: axes.grid.spacing.to: must be greater than from"},
      {"{from: 0, to: 1, log: true}", "22: axes.grid.spacing: a logarithmic span begins above 0"},
      {"{from: -1, to: 1, log: true}", "22: axes.grid.spacing: a logarithmic span begins above 0"},
      {"{from: a, to: 1}", "29: axes.grid.spacing.from: must be a number, found 'a'"},
      {"{from: 1, to: .inf}", "36: axes.grid.spacing.to: must be a finite number, found '.inf'"},
      {"{from: 1, to: 2, log: 1}", "44: axes.grid.spacing.log: must be true or false, found '1': write true"},
      {"{from: 1, to: 2, whole: yes}", "46: axes.grid.spacing.whole: must be true or false, found 'yes': write true"},
      {"{from: 1, to: 2, step: 1}", "39: axes.grid.spacing.step: unknown key; known: from, to, log, whole"},
      {"{from: 1.5, to: 2, whole: true}", "29: axes.grid.spacing.from: must be a whole number, found '1.5'"},
      {"{from: 1, to: 2.5, whole: true}", "36: axes.grid.spacing.to: must be a whole number, found '2.5'"},
  };
  for (const auto& [span, refusal] : spans) {
    EXPECT_EQ(refused_axes("{grid.spacing: " + std::string(span) + "}", of_five),
              std::string("study.yaml:2:") + refusal);
  }
  for (const char* sampling : {"", "sampling: product\n", "sampling: list\ncases: [{grid.spacing: 1}]\n"}) {
    EXPECT_EQ(refused_axes("{grid.spacing: {from: 1, to: 2}}", sampling),
              "study.yaml:2:8: axes.grid.spacing: a span goes with sampling: {latin_hypercube: count}");
  }
}

TEST(AxesReader, BadAxesAreRefused) {
  const std::pair<const char*, const char*> axes[] = {
      {"[grid.spacing]",
       "7: axes: must be a map of keys, found a list: its keys stand without '-' and brackets; known: names of axes"},
      {"{grid.spacing: []}", "22: axes.grid.spacing: has no values"},
      {"{method: {}}", "16: axes.method: has no values"},
      {"{grid.spacing: 0.5}", "22: axes.grid.spacing: must be a list of values, found '0.5': write [0.5]"},
      {"{grid.spacing: }",
       "8: axes.grid.spacing: must be a map of keys, found nothing; known: a list of values, "
       "{from, to}, or named levels"},
      {"{method: {CPDI: cpdi}}",
       "23: axes.method.CPDI: must be a map of keys, found 'cpdi'; known: dotted keys of a "
       "scene"},
      {"{time.end: [0, 1, -0.0]}", "18: axes.time.end: holds '-0.0' twice"},
      {"{grid.spacing: [.nan, .nan]}", "22: axes.grid.spacing: holds '.nan' twice"},
      {"{grid.spacing: [0.05, 0.1, 5.0e-2]}", "22: axes.grid.spacing: holds '5.0e-2' twice"},
      {"{method.basis: [cpdi, cpdi]}", "22: axes.method.basis: holds 'cpdi' twice"},
      {"{method: {1: {threads: 1}, 1.0: {threads: 2}}}", "16: axes.method: holds '1.0' twice"},
      {"{grid.spacin: [1]}", "8: axes.grid.spacin: unknown key of a scene 'grid.spacin' (nearest: grid.spacing)"},
      {"{grid.spacin: {from: 1, to: 2}}",
       "8: axes.grid.spacin: unknown key of a scene 'grid.spacin' (nearest: grid.spacing)"},
      {"{thread: [1]}", "8: axes.thread: unknown key of a scene 'thread' (nearest: threads)"},
      {"{a: {b: {method.basi: cpdi}}}",
       "16: axes.a.b.method.basi: unknown key of a scene 'method.basi' (nearest: "
       "method.basis)"},
      {"{'': [1]}", "8: axes.: unknown key of a scene ''"},
  };
  for (const auto& [text, refusal] : axes) EXPECT_EQ(refused_axes(text), std::string("study.yaml:2:") + refusal);
  EXPECT_EQ(StudyFolder().refusal("title: none\n"), "study.yaml:1:1: axes: required and not given");
  EXPECT_EQ(StudyFolder().refusal("axes: {}\n"),
            "study.yaml:2:7: axes: is empty: write keys of the scene and their values, as grid.spacing: [0.1, 0.05]");
  EXPECT_EQ(StudyFolder().refusal("axes: {threads: [1]}\nset: {grid.spacin: 1}\n"),
            "study.yaml:3:7: set.grid.spacin: unknown key of a scene 'grid.spacin' (nearest: grid.spacing)");
}

TEST(AxesReader, TwoAxesThatSetTheSameKeyAreRefused) {
  EXPECT_EQ(refused_axes("{method: {a: {method.courant: 0.4}, b: {}}, method.courant: [0.1, 0.2]}"),
            "study.yaml:2:51: axes.method.courant: sets 'method.courant', which 'method' sets too");
  EXPECT_EQ(refused_axes("{a: {x: {threads: 1}}, b: {y: {time.end: 1}, z: {threads: 2}}}"),
            "study.yaml:2:30: axes.b: sets 'threads', which 'a' sets too");
  EXPECT_EQ(refused_axes("{motion.amplitude.peak: [1, 2], motion: [{type: vortex}]}"),
            "study.yaml:2:39: axes.motion: sets 'motion', and so 'motion.amplitude.peak', which "
            "'motion.amplitude.peak' sets too");
  EXPECT_EQ(refused_axes("{motion: [{type: vortex}], motion.amplitude.peak: [1, 2]}"), "accepted")
      << "adds to what the first has set";
  EXPECT_EQ(refused_axes("{grid: [{spacing: 1}, {spacing: 2}], grid.spacing: [3]}"),
            "study.yaml:2:44: axes.grid.spacing: sets 'grid.spacing', which 'grid' sets too");
  EXPECT_EQ(refused_axes("{grid.offset.0: [0.1], 'grid.offset[0]': [0.2]}"),
            "study.yaml:2:30: axes.grid.offset[0]: sets 'grid.offset.0', which 'grid.offset.0' sets too");
  EXPECT_EQ(refused_axes("{m: {a: {grid.offset.0: 0.1, 'grid.offset[0]': 0.2}}}"),
            "study.yaml:2:36: axes.m.a.grid.offset[0]: stands beside 'grid.offset.0'");
  EXPECT_EQ(refused_axes("{'grid.offset[0]': [0.1], 'grid.offset[1]': [0.2]}"), "accepted");
  EXPECT_EQ(refused_axes("{m: {a: {method.basis: cpdi, method: {basis: linear}}}}"),
            "study.yaml:2:36: axes.m.a.method: stands beside 'method.basis'");
  EXPECT_EQ(refused_axes("{method: {a: {method.courant: 0.4}, b: {method.courant: 0.2}}}"), "accepted");
  EXPECT_EQ(refused_axes("{body.seed: [1], body.jitter: [0.1]}"), "accepted");
}

TEST(AxesReader, TheAxisOfResolutionSetsNothingElseThatDiffersButNumbers) {
  const auto refined = [](const std::string& axes) {
    return StudyFolder().refusal("axes: " + axes + "\nrefine: grid.spacing\n");
  };
  EXPECT_EQ(refined("{n: {a: {grid.spacing: 1, time.step: 1}, b: {grid.spacing: 2, time.step: 2}}}"), "accepted");
  EXPECT_EQ(refined("{n: {a: {grid.spacing: 1, method.basis: cpdi}, b: {grid.spacing: 2, method.basis: cpdi}}}"),
            "accepted");
  EXPECT_EQ(
      refined("{n: {a: {grid.spacing: 1, method.basis: cpdi}, b: {grid.spacing: 2}}}"),
      "study.yaml:2:33: axes.n: sets 'method.basis' beside 'grid.spacing': cases of a series differ in resolution "
      "alone; make it an axis of its own");
}

TEST(AxesReader, AListMakesAxesOfKeysAndTakesLevels) {
  const Study study = StudyFolder().read(
      "axes: {method: {CPDI: {method.basis: cpdi}, uGIMP: {method.basis: ugimp}}}\n"
      "sampling: list\n"
      "cases:\n"
      "  - {method: CPDI, grid.spacing: 0.5}\n"
      "  - {grid.spacing: 5.0e-1, time.end: 0.5}\n"
      "  - {grid.spacing: 0.25, method: uGIMP}\n"
      "  - {}\n");
  ASSERT_EQ(study.axes.size(), 3u);
  EXPECT_EQ(study.axes[1].name, "grid.spacing");
  EXPECT_TRUE(study.axes[1].is_key);
  EXPECT_EQ(level_names(study.axes[1]), (std::vector<std::string>{"0.5", "0.25"})) << "numbers are numbers";
  EXPECT_EQ(level_names(study.axes[2]), (std::vector<std::string>{"0.5"}));
  ASSERT_EQ(study.listed.size(), 4u);
  EXPECT_EQ(study.listed[1].size(), 2u);
  EXPECT_TRUE(study.listed[3].empty());
}

TEST(AxesReader, BadListsAreRefused) {
  const std::string axes = "axes: {method: {CPDI: {method.basis: cpdi}}}\nsampling: list\n";
  const auto refused = [&](const std::string& cases) { return StudyFolder().refusal(axes + "cases: " + cases + "\n"); };
  EXPECT_EQ(refused("[]"), "study.yaml:4:8: cases: must be a list of maps of axes to values");
  EXPECT_EQ(refused("{method: CPDI}"), "study.yaml:4:8: cases: must be a list of maps of axes to values");
  EXPECT_EQ(refused("[{method: CPDI}, CPDI]"),
            "study.yaml:4:25: cases[1]: must be a map of keys, found 'CPDI'; known: method");
  EXPECT_EQ(refused("[{method: CPDJ}]"),
            "study.yaml:4:18: cases[0].method: unknown value 'CPDJ' (nearest: CPDI); known: CPDI");
  EXPECT_EQ(refused("[{grid.spacin: 1}]"),
            "study.yaml:4:10: cases[0]: unknown key of a scene 'grid.spacin' (nearest: grid.spacing)");
}

TEST(AxesReader, ManyValuesAreReadInNoTime) {
  std::string values;
  for (int i = 0; i < 60000; ++i) values += (i == 0 ? "" : ",") + std::to_string(i);
  const Study study = StudyFolder().read("axes: {body.seed: [" + values + "]}\n");
  EXPECT_EQ(study.axes.at(0).levels.size(), 60000u);
  EXPECT_TRUE(refused_axes("{body.seed: [" + values + ",7e0]}").ends_with("axes.body.seed: holds '7e0' twice"));
}

TEST(AxesReader, AListAndOneOfItsValuesAreOneKey) {
  for (const char* axes :
       {"{body.per_cell: [[1, 1], [2, 2]], body.per_cell.0: [1, 2]}",
        "{body.per_cell.0: [1, 2], body.per_cell: [[1, 1], [2, 2]]}",
        "{b: {x: {body: {per_cell: [1, 1]}}, y: {body: {per_cell: [2, 2]}}}, body.per_cell.0: [1, 2]}"}) {
    EXPECT_NE(StudyFolder().refusal("axes: " + std::string(axes) + "\n").find("sets too"), std::string::npos) << axes;
  }
  EXPECT_NE(StudyFolder().refusal("axes: {body.per_cell.00: [1, 2]}\n").find("unknown key of a scene"),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_axes_reader
