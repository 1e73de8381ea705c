// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_reader.hpp"

#include <gtest/gtest.h>

#include "drivers/check/replay.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/study/plan/study_reader.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_file_kind {
namespace {

const std::string study = "scene: s.yaml\naxes: {grid.spacing: [0.1]}\n", description = "library: m.so\n",
                  replay = "material: m\nF0: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";

TEST(FileKind, AnotherThanIsWantedIsNamedWithItsVerb) {
  const ScratchFolder scratch;
  const auto as_scene = [](const std::string& text) { return refusal_of([&] { scene_from_text(text, "f.yaml"); }); };
  EXPECT_EQ(as_scene(study), "f.yaml:1:1: this is a study, not a scene: use `assay study`");
  EXPECT_EQ(as_scene(description), "f.yaml:1:1: this is the description of a material, not a scene: use `assay check`");
  EXPECT_EQ(as_scene(replay), "f.yaml:1:1: this is a replay file, not a scene: use `assay check --replay`");
  EXPECT_EQ(refusal_of([] { study_from_text(scene_text(), "f.yaml"); }),
            "f.yaml:1:1: this is a scene, not a study: use `assay run`");
  EXPECT_EQ(refusal_of([] { study_from_text(description, "f.yaml"); }),
            "f.yaml:1:1: this is the description of a material, not a study: use `assay check`");
  EXPECT_EQ(refusal_of([] { read_description(scene_text(), "f.yaml"); }),
            "f.yaml:1:1: this is a scene, not the description of a material: use `assay run`");
  EXPECT_EQ(refusal_of([&] { read_replay(scratch.write("s.yaml", scene_text())); }),
            scratch / "s.yaml" + ":1:1: this is a scene, not a replay file: use `assay run`");
}

TEST(FileKind, ResultsAreNamedAsSuch) {
  EXPECT_EQ(refusal_of([] { scene_from_text("{\"outcome\": \"completed\", \"time\": {}}", "result.json"); }),
            "result.json:1:1: this is the result of a run: its scene is resolved.yaml in the same folder");
  EXPECT_EQ(refusal_of([] { study_from_text("{\"format\": \"assay study\", \"axes\": []}", "study.json"); }),
            "study.json:1:1: this is the result of a study: its study is study.yaml in the same folder");
  EXPECT_EQ(refusal_of([] { read_description("{\"material\": \"m\", \"tests\": []}", "c.json"); }),
            "c.json:1:1: this is what `assay check` has found: its replays are the YAML files that it names");
  EXPECT_EQ(
      refusal_of([] {
        scene_from_text(
            "\x7f"
            "ELF\x02\x01",
            "m.so");
      }),
      "m.so:1:1: this is a library, not a text: a scene names it by material.adapter, and `assay check` takes it");
}

TEST(FileKind, AKeyOfTheWantedKindIsEnough) {
  const auto key = [](const std::string& text) {
    const std::string line = refusal_of([&] { scene_from_text(text, "f.yaml"); });
    return line.find("this is") == line.npos;
  };
  EXPECT_TRUE(key(scene_text("scene: x\n")));
  EXPECT_TRUE(key("grid: {}\nlibrary: x\n"));
  EXPECT_TRUE(key("title: of neither\n"));
}

}  // namespace
}  // namespace assay::drivers::test_file_kind
