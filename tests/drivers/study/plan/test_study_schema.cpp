// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/plan/study_reader.hpp"

#include <filesystem>

#include "drivers/format/yaml_values.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/drivers/json_schema.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_study_schema {
namespace {

const json& schema_of_studies() {
  static const json schema = json::parse(study_schema_json());
  return schema;
}

bool schema_takes(const std::string& yaml) { return valid(schema_of_studies(), json_of(read_yaml(yaml, "f"))); }

TEST(StudySchema, HasANameOfItsOwn) {
  EXPECT_EQ(schema_of_studies()["$id"], "urn:assay:schema:study:" + build_information().version);
}

TEST(StudySchema, ListsTheKeysOfTheReader) {
  std::set<std::string> listed;
  for (const auto& [name, ignored] : schema_of_studies()["properties"].items()) listed.insert(name);
  EXPECT_EQ(listed, std::set<std::string>(study_keys().begin(), study_keys().end()));
}

TEST(StudySchema, TakesEveryShippedStudy) {
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(tree_folder() + "/configs/studies")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_TRUE(schema_takes(read_bytes(entry.path().string()))) << entry.path();
    ++seen;
  }
  EXPECT_GE(seen, 6);
}

const std::string short_study = "scene: " + tree_folder() + "/configs/paper/vortex_square.yaml\n";

TEST(StudySchema, TakesEveryFormOfAnAxisASelectionAndASetting) {
  const std::string study = short_study +
                            "set: {material.parameters.E: 500, output: {errors: 5}}\n"
                            "sampling: {latin_hypercube: 4, seed: 2}\n"
                            "axes:\n"
                            "  grid.spacing: [0.1, 0.05]\n"
                            "  motion.amplitude.peak: {from: 0.1, to: 1, log: true, whole: false}\n"
                            "  method: {one: {method.basis: cpdi, threads: 2}, two: {method.basis: linear}}\n"
                            "exclude: [{method: one, grid.spacing: {above: 0.07}}, {method: {not: [one]}}]\n"
                            "timing: {repeat: 2, where: {grid.spacing: {between: [0, 1]}}}\n"
                            "budget: {of: {method: one}, step: {method.courant: 0.1}}\n"
                            "expect: [{where: {method: [one, two]}, outcome: n/a}, {order: {above: 1}}]\n";
  EXPECT_TRUE(schema_takes(study));
  EXPECT_EQ(refusal_of([&] { study_from_text(study, "f"); }), "accepted");
}

TEST(StudySchema, RefusesWhatTheReaderRefuses) {
  const std::string axes = "axes: {grid.spacing: [0.1]}\n";
  ASSERT_TRUE(schema_takes(short_study + axes));
  const std::vector<std::string> bad{"axes: {grid.spacing: []}",
                                     "axes: {grid.spacing: {from: 1}}",
                                     "axes: {m: {one: {method.bases: cpdi}}}",
                                     axes + "set: {grid.size: 1}",
                                     axes + "axis: 1",
                                     axes + "error: error.l2",
                                     axes + "error: outcome",
                                     axes + "invalid: maybe",
                                     axes + "sampling: random",
                                     axes + "timing: some",
                                     axes + "timing: {repeat: 0}",
                                     axes + "exclude: [{grid.spacing: {belw: 1}}]",
                                     axes + "exclude: [{grid.spacing: {below: 1, above: 2}}]",
                                     axes + "published: [{order: 1}]",
                                     axes + "expect: [{outcome: done}]",
                                     axes + "expect: {outcome: completed}",
                                     axes + "budget: {step: {courant: 1}}"};
  for (const std::string& extra : bad) {
    EXPECT_FALSE(schema_takes(short_study + extra)) << extra;
    EXPECT_NE(refusal_of([&] { study_from_text(short_study + extra, "f"); }), "accepted") << extra;
  }
  EXPECT_FALSE(schema_takes(axes));
}

}  // namespace
}  // namespace assay::drivers::test_study_schema
