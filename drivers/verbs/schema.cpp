// SPDX-License-Identifier: BSD-3-Clause
// `assay schema`: what an editor completes and checks scenes and studies by.
#include <CLI/CLI.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/path/path_schema.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/study/plan/study_reader.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

Act add_schema_arguments(VerbArguments& verb) {
  struct Asked {
    bool studies = false, paths = false;
  };
  const auto asked = std::make_shared<Asked>();
  auto* studies = verb.app.add_flag("--study", asked->studies, "the schema of studies");
  verb.app.add_flag("--path", asked->paths, "the schema of paths")->excludes(studies);
  return [asked](Verbosity) {
    print(asked->studies ? study_schema_json() : asked->paths ? path_schema_json() : schema_json());
    return 0;
  };
}

}  // namespace

Verb verb_schema() {
  return {50, "JSON Schema of scenes, studies, paths for editors", "assay schema > scene.schema.json",
          add_schema_arguments};
}

}  // namespace assay::drivers
