// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/text/sha256.hpp"
#include "tests/drivers/study/study_text_fixture.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_study_reader {
namespace {

bool is_text_figure(const std::string& key) { return figure_of_result(key).kind == Field::Kind::text; }

const std::string two_axes = "axes: {method.basis: [cpdi, ugimp], grid.spacing: [0.75, 0.5]}\n";  // line 2

/// Refusals of lines after two axes; the first of them is line 3.
std::string refused_after_axes(const std::string& lines) { return StudyFolder().refusal(two_axes + lines); }

TEST(StudyReader, EveryKeyIsTaken) {
  const StudyFolder folder;
  const std::string text =
      "title: A title\n"
      "question: Which?\n"
      "set: {body.per_cell: [1, 1], threads: 2}\n"
      "axes:\n"
      "  method:\n"
      "    CPDI: {method.basis: cpdi}\n"
      "    uGIMP: {method.basis: ugimp, method.courant: 0.2}\n"
      "  grid.spacing: [0.75, 0.5]\n"
      "sampling: product\n"
      "exclude: [{method: CPDI, grid.spacing: {below: 0.6}}]\n"
      "refine: grid.spacing\n"
      "error: error.l2_end\n"
      "cost: work.particle_steps\n"
      "invalid: skip\n"
      "limit: 12.5\n"
      "timing: {repeat: 5, seconds: 7, where: {method: uGIMP}}\n"
      "budget: {of: {method: uGIMP}, space: {grid.spacing: 0.25}, time: {method.courant: 0.1, time.end: 0.5}}\n"
      "published: [{where: {method: CPDI}, order: 0.8, source: a paper}]\n"
      "expect: [{where: {method: CPDI}, outcome: completed, order: {above: 1}, order_last: 2}, {t: 1}]\n";
  const Study study = folder.read(text);
  EXPECT_EQ(study.title, "A title");
  EXPECT_EQ(study.question, "Which?");
  EXPECT_EQ(study.file, folder.file());
  EXPECT_EQ(study.text, "scene: s.yaml\n" + text);
  EXPECT_EQ(study.sha256, sha256_hex(study.text));
  EXPECT_EQ(study.scene, folder.scratch() / "s.yaml");
  EXPECT_EQ(study.scene_where.line, 1);
  ASSERT_EQ(study.set.size(), 2u);
  EXPECT_EQ(study.set[0].path, "body.per_cell");
  EXPECT_EQ(flow_text(study.set[0].value), "[1, 1]");
  EXPECT_EQ(study.set[1].path, threads_key);
  ASSERT_EQ(study.axes.size(), 2u);
  EXPECT_EQ(study.axes[0].name, "method");
  EXPECT_FALSE(study.axes[0].is_key);
  ASSERT_EQ(study.axes[0].levels.size(), 2u);
  EXPECT_EQ(study.axes[0].levels[1].name, "uGIMP");
  ASSERT_EQ(study.axes[0].levels[1].settings.size(), 2u);
  EXPECT_EQ(study.axes[0].levels[1].settings[1].path, "method.courant");
  EXPECT_TRUE(study.axes[1].is_key);
  EXPECT_EQ(study.axes[1].levels[1].name, "0.5");
  EXPECT_EQ(study.sampling.type, Sampling::Type::product);
  ASSERT_EQ(study.excluded.size(), 1u);
  EXPECT_TRUE(study.excluded[0].holds({{"method", "CPDI"}, {"grid.spacing", "0.5"}}));
  EXPECT_FALSE(study.excluded[0].holds({{"method", "CPDI"}, {"grid.spacing", "0.75"}}));
  EXPECT_EQ(study.refine, "grid.spacing");
  EXPECT_EQ(study.error, "error.l2_end");
  EXPECT_EQ(study.cost, "work.particle_steps");
  EXPECT_TRUE(study.skips_invalid);
  EXPECT_EQ(study.case_seconds, 12.5);
  EXPECT_EQ(study.timing.repeat, 5);
  EXPECT_EQ(study.timing.seconds, 7);
  EXPECT_FALSE(study.timing.none);
  EXPECT_FALSE(study.timing.where.holds({{"method", "CPDI"}}));
  EXPECT_TRUE(study.timing.where.holds({{"method", "uGIMP"}}));
  ASSERT_TRUE(study.budget);
  EXPECT_TRUE(study.budget->of.holds({{"method", "uGIMP"}}));
  EXPECT_FALSE(study.budget->of.holds({{"method", "CPDI"}}));
  ASSERT_EQ(study.budget->sources.size(), 2u);
  EXPECT_EQ(study.budget->sources[0].name, "space");
  EXPECT_EQ(study.budget->sources[1].settings.size(), 2u);
  ASSERT_EQ(study.published.size(), 1u);
  EXPECT_EQ(study.published[0].order, 0.8);
  EXPECT_EQ(study.published[0].source, "a paper");
  EXPECT_FALSE(study.published[0].where.holds({{"method", "uGIMP"}}));
  ASSERT_EQ(study.expect.size(), 5u);
  EXPECT_EQ(study.expect[0].line.text, "completed");
  EXPECT_EQ(study.expect[1].line.key, order_key);
  EXPECT_EQ(study.expect[1].line.op, Expectation::Operator::above);
  EXPECT_EQ(study.expect[2].line.key, last_order_key);
  EXPECT_FALSE(study.expect[2].where.holds({{"method", "uGIMP"}}));
  EXPECT_TRUE(study.expect[3].where.holds({{"method", "uGIMP"}}));
  EXPECT_TRUE(study.expect[4].implied) << "completed, of those of whose outcome nothing is said";
  EXPECT_FALSE(study.expect[3].implied);
}

TEST(StudyReader, WhatIsNotGivenHasItsDefault) {
  const Study study = StudyFolder().read(two_axes);
  EXPECT_EQ(study.title, "");
  EXPECT_EQ(study.error, "error.relative");
  EXPECT_EQ(study.cost, "step_cpu_s");
  EXPECT_EQ(study.sampling.type, Sampling::Type::product);
  EXPECT_EQ(study.refine, "");
  EXPECT_FALSE(study.skips_invalid);
  EXPECT_EQ(study.case_seconds, 0);
  EXPECT_EQ(study.timing.repeat, 3);
  EXPECT_EQ(study.timing.seconds, 60);
  EXPECT_FALSE(study.timing.none);
  EXPECT_TRUE(study.timing.where.holds({}));
  EXPECT_FALSE(study.budget);
  EXPECT_FALSE(StudyFolder().read(two_axes + "invalid: refuse\n").skips_invalid);
  EXPECT_TRUE(StudyFolder().read(two_axes + "timing: none\n").timing.none);
}

TEST(StudyReader, TheShippedStudiesAreRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(tree_folder() + "/configs/studies")) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_EQ(refusal_of([&] { read_study(entry.path().string()); }), "accepted");
  }
  EXPECT_GE(count, 3);
}

TEST(StudyReader, WhatIsNoMapIsRefused) {
  EXPECT_EQ(refusal_of([] { study_from_text("", "f"); }), "f: empty");
  EXPECT_EQ(refusal_of([] { study_from_text("# nothing\n", "f"); }), "f: empty");
  EXPECT_TRUE(refusal_of([] { study_from_text("[1]\n", "f"); })
                  .starts_with("f:1:1: must be a map of keys, found a list: its keys stand without '-' and brackets; "
                               "known: title, question, "));
  EXPECT_TRUE(refusal_of([] { study_from_text("a: [\n", "f"); }).starts_with("f:1:4: ")) << "of the YAML reader";
  EXPECT_TRUE(refusal_of([] { study_from_text("title: a\ntitle: b\n", "f"); }).starts_with("f:2:1: title: "))
      << "duplicate keys";
  EXPECT_TRUE(refusal_of([] { read_study("/nowhere/study.yaml"); }).starts_with("/nowhere/study.yaml: "));
}

TEST(StudyReader, UnknownKeysNameTheNearest) {
  EXPECT_TRUE(
      StudyFolder()
          .refusal("axis: {}\n")
          .starts_with(
              "study.yaml:2:1: axis: unknown key (nearest: axes); known: title, question, answer, scene, set, "
              "axes, sampling, cases, "
              "exclude, not_applicable, refine, error, cost, invalid, limit, timing, budget, published, expect"));
  EXPECT_EQ(refused_after_axes("timing: {repeats: 2}\n"),
            "study.yaml:3:10: timing.repeats: unknown key (nearest: repeat); known: repeat, seconds, where");
  EXPECT_EQ(refused_after_axes("sampling: {latin_hypercub: 2}\n"),
            "study.yaml:3:12: sampling.latin_hypercub: unknown key (nearest: latin_hypercube); known: "
            "latin_hypercube, seed");
  EXPECT_EQ(refused_after_axes("published: [{order: 1, sources: a}]\n"),
            "study.yaml:3:24: published[0].sources: unknown key (nearest: source); known: where, order, source");
  EXPECT_TRUE(refused_after_axes("expect: [{t: 1}, {ordr: 1}]\n")
                  .starts_with("study.yaml:3:19: expect[1].ordr: unknown key (nearest: order); known: order, "));
}

TEST(StudyReader, SurvivalIsAskedOfMethods) {
  const std::string methods = "axes: {method: {a: {method.basis: cpdi}, b: {method.basis: ugimp}}}\n";
  EXPECT_TRUE(StudyFolder().read(methods + "answer: survival\n").asks_survival);
  EXPECT_FALSE(StudyFolder().read(methods + "answer: cost\n").asks_survival);
  EXPECT_EQ(refused_after_axes("answer: survival\n"),
            "study.yaml:3:9: answer: survival is asked of the values of an axis 'method', which is not there");
  EXPECT_TRUE(refused_after_axes("answer: yes\n").starts_with("study.yaml:3:9: answer: unknown value 'yes'"));
}

TEST(StudyReader, TheSceneMustBeThere) {
  const StudyFolder folder;
  const auto refused = [&](const std::string& text) {
    return folder.shortened_line(refusal_of([&] { study_from_text(text, folder.file()); }));
  };
  EXPECT_EQ(refused("title: a\n"), "study.yaml:1:1: scene: required and not given");
  EXPECT_EQ(refused("scene: t.yaml\n"), "study.yaml:1:8: scene: no such file: 't.yaml'");
  EXPECT_EQ(refused("scene: [s.yaml]\n"), "study.yaml:1:8: scene: must be text, found a list");
  EXPECT_TRUE(refused("scene: .\n").ends_with("is a folder, not a file")) << refused("scene: .\n");
  EXPECT_EQ(folder.read(two_axes).scene, folder.scratch() / "s.yaml");
  const std::string absolute = "scene: " + (folder.scratch() / "s.yaml") + "\n" + two_axes;
  EXPECT_EQ(study_from_text(absolute, "elsewhere/study.yaml").scene, folder.scratch() / "s.yaml");
}

TEST(StudyReader, WrongTypesAreRefusedWhereTheyStand) {
  const std::pair<const char*, const char*> lines[] = {
      {"title: [a]", "3:8: title: must be text, found a list"},
      {"question: {a: b}", "3:11: question: must be text, found a map"},
      {"set: [a]",
       "3:6: set: must be a map of keys, found a list: its keys stand without '-' and brackets; known: dotted keys of "
       "a scene"},
      {"set: {grid.spacing: }\nexclude: 3", "4:10: exclude: must be a list of maps"},
      {"exclude: [grid.spacing]",
       "3:11: exclude: must be a map of keys, found 'grid.spacing'; known: axes of the study"},
      {"invalid: sometimes", "3:10: invalid: unknown value 'sometimes'; known: refuse, skip"},
      {"limit: -1", "3:8: limit: must be from 0 to 1e+09, found '-1'"},
      {"limit: '1'", "3:8: limit: must be a number, found '1' in quotes, which make it a text: write 1"},
      {"limit: .nan", "3:8: limit: must be a finite number, found '.nan'"},
      {"timing: [1]",
       "3:9: timing: must be a map of keys, found a list: its keys stand without '-' and brackets; known: none, or a "
       "map of "
       "repeat, seconds, where"},
      {"timing: always", "3:9: timing: unknown value 'always'; known: none"},
      {"timing: {repeat: 0}", "3:18: timing.repeat: must be from 1 to 1000, found '0'"},
      {"timing: {repeat: 1.5}", "3:18: timing.repeat: must be a whole number, found '1.5'"},
      {"timing: {seconds: -1}", "3:19: timing.seconds: must be from 0 to 1e+09, found '-1'"},
      {"budget: 3", "3:9: budget: must be a map of keys, found '3'; known: of, and names of sources"},
      {"budget: {of: {grid.spacing: 0.5}}", "3:9: budget: names no source and what makes it finer"},
      {"budget: {space: 3}", "3:17: budget.space: must be a map of keys, found '3'; known: dotted keys of a scene"},
      {"published: {order: 1}", "3:12: published: must be a list of maps"},
      {"published: [3]", "3:13: published[0]: must be a map of keys, found '3'; known: where, order, source"},
      {"published: [{order: 1}]", "3:13: published[0].source: required and not given"},
      {"published: [{source: a}]", "3:13: published[0].order: required and not given"},
      {"published: [{source: a, order: b}]", "3:32: published[0].order: must be a number, found 'b'"},
      {"expect: {t: 1}", "3:9: expect: must be a list of maps, found a map"},
      {"expect: [t]", "3:10: expect[0]: must be a map of keys, found 't'; known: where, and keys of result.json"},
      {"expect: [{order: fast}]", "3:18: expect[0].order: must be a number, found 'fast'"},
  };
  for (const auto& [line, refusal] : lines) {
    EXPECT_EQ(refused_after_axes(std::string(line) + "\n"), std::string("study.yaml:") + refusal);
  }
}

TEST(StudyReader, ErrorAndCostAreNumbersOfTheResult) {
  EXPECT_TRUE(
      refused_after_axes("error: error.relativ\n")
          .starts_with("study.yaml:3:8: error: unknown value 'error.relativ' (nearest: error.relative); known: "));
  EXPECT_TRUE(refused_after_axes("cost: outcome\n").starts_with("study.yaml:3:7: cost: unknown value 'outcome'"));
  EXPECT_TRUE(refused_after_axes("cost: [t]\n").starts_with("study.yaml:3:7: cost: must be a word, found a list"));
  for (const std::string& key : flat_keys()) {
    EXPECT_EQ(refused_after_axes("error: " + key + "\n") == "accepted", !is_text_figure(key)) << key;
  }
}

TEST(StudyReader, ExpectationsKnowHowACaseOfAStudyCanEnd) {
  for (const char* outcome : {"completed", "unstable", "material_failed", "refused", "n/a", "crashed", "stopped"}) {
    EXPECT_EQ(refused_after_axes("expect: [{outcome: " + std::string(outcome) + "}]\n"), "accepted") << outcome;
  }
  EXPECT_EQ(refused_after_axes("expect: [{outcome: complete}]\n"),
            "study.yaml:3:20: expect[0].outcome: unknown value 'complete' (nearest: completed); known: completed, "
            "unstable, material_failed, refused, n/a, crashed, stopped");
}

TEST(StudyReader, AnExpectationSaysWhatIsExpected) {
  EXPECT_EQ(refused_after_axes("expect: [{where: {grid.spacing: 0.5}}]\n"),
            "study.yaml:3:10: expect[0]: names nothing that is expected");
  EXPECT_EQ(refused_after_axes("expect: [{}]\n"), "study.yaml:3:10: expect[0]: names nothing that is expected");
}

TEST(StudyReader, SelectionsNameAxesAndValuesThatAreThere) {
  const std::pair<const char*, const char*> places[] = {
      {"exclude: [%]", "exclude"},
      {"timing: {where: %}", "timing.where"},
      {"budget: {of: %, a: {time.end: 0.5}}", "budget.of"},
      {"published: [{order: 1, source: a, where: %}]", "published[0].where"},
      {"expect: [{t: 1, where: %}]", "expect[0].where"}};
  for (const auto& [line, key] : places) {
    const std::string text = line;
    const std::size_t at = text.find('%');
    const auto refused = [&](const std::string& map) {
      return refused_after_axes(std::string(text).replace(at, 1, map) + "\n");
    };
    const std::string place = "study.yaml:3:" + std::to_string(at + 2) + ": " + key + ".";
    EXPECT_EQ(refused("{grid.spacin: 0.5}"),
              place + "grid.spacin: unknown axis (nearest: grid.spacing); known: method.basis, grid.spacing");
    EXPECT_EQ(refused("{method.basis: cpdi2}"),
              place + "method.basis: unknown value 'cpdi2' (nearest: cpdi); known: cpdi, ugimp");
    EXPECT_EQ(refused("{grid.spacing: [0.5, 0.6]}"),
              place + "grid.spacing: unknown value '0.6' (nearest: 0.5); known: 0.75, 0.5");
    EXPECT_EQ(refused("{grid.spacing: {not: 0.6}}"),
              place + "grid.spacing: unknown value '0.6' (nearest: 0.5); known: 0.75, 0.5");
    EXPECT_EQ(refused("{grid.spacing: 5.0e-1, method.basis: {not: [cpdi]}}"), "accepted") << "numbers are numbers";
  }
}

TEST(StudyReader, SamplingIsOneOfThree) {
  EXPECT_EQ(refused_after_axes("sampling: random\n"),
            "study.yaml:3:11: sampling: unknown value 'random'; known: product, list");
  EXPECT_EQ(refused_after_axes("sampling: [list]\n"),
            "study.yaml:3:11: sampling: must be a map of keys, found a list: its keys stand without '-' and brackets; "
            "known: product, list, or a map of "
            "latin_hypercube and seed");
  EXPECT_EQ(refused_after_axes("sampling: {seed: 3}\n"),
            "study.yaml:3:11: sampling.latin_hypercube: required and not given");
  EXPECT_EQ(refused_after_axes("sampling: {latin_hypercube: 0}\n"),
            "study.yaml:3:29: sampling.latin_hypercube: must be from 1 to 1e+05, found '0'");
  EXPECT_EQ(refused_after_axes("sampling: {latin_hypercube: 1e9}\n"),
            "study.yaml:3:29: sampling.latin_hypercube: must be from 1 to 1e+05, found '1e9'");
  EXPECT_EQ(refused_after_axes("sampling: {latin_hypercube: 2, seed: 1.5}\n"),
            "study.yaml:3:38: sampling.seed: must be a whole number, found '1.5'");
  const Study study = StudyFolder().read(two_axes + "sampling: {latin_hypercube: 7, seed: 9}\n");
  EXPECT_EQ(study.sampling.type, Sampling::Type::latin_hypercube);
  EXPECT_EQ(study.sampling.count, 7);
  EXPECT_EQ(study.sampling.seed, 9);
  EXPECT_EQ(StudyFolder().read(two_axes + "sampling: {latin_hypercube: 7}\n").sampling.seed, 1);
}

TEST(StudyReader, CasesAndListGoTogether) {
  EXPECT_EQ(refused_after_axes("cases: [{grid.spacing: 0.5}]\n"),
            "study.yaml:3:8: cases: goes with sampling: list, which needs it");
  EXPECT_EQ(refused_after_axes("sampling: list\n"), "study.yaml:1:1: cases: goes with sampling: list, which needs it");
  EXPECT_EQ(refused_after_axes("sampling: {latin_hypercube: 2}\ncases: [{grid.spacing: 0.5}]\n"),
            "study.yaml:4:8: cases: goes with sampling: list, which needs it");
  EXPECT_EQ(refused_after_axes("sampling: list\ncases: [{grid.spacing: 0.5}]\n"), "accepted");
}

TEST(StudyReader, ARefinedKeyIsSetByAnAxis) {
  EXPECT_EQ(refused_after_axes("refine: time.step\n"),
            "study.yaml:3:9: refine: no axis sets 'time.step'; known: method.basis, grid.spacing");
  EXPECT_EQ(refused_after_axes("refine: [a]\n"), "study.yaml:3:9: refine: must be text, found a list");
  EXPECT_EQ(StudyFolder().refusal("axes: {cells: {few: {grid.spacing: 0.5}}}\nrefine: grid.spacing\n"), "accepted")
      << "a level that sets it is enough";
}

}  // namespace
}  // namespace assay::drivers::test_study_reader
