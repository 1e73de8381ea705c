// SPDX-License-Identifier: BSD-3-Clause
// `assay schema`: what an editor completes and checks scenes and studies by.
#include <CLI/CLI.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/study/plan/study_reader.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

Act add_schema_arguments(VerbArguments& verb) {
  const auto of_studies = std::make_shared<bool>(false);
  verb.app.add_flag("--study", *of_studies, "the schema of studies");
  return [of_studies](Verbosity) {
    print(*of_studies ? study_schema_json() : schema_json());
    return 0;
  };
}

}  // namespace

Verb verb_schema() {
  return {50, "JSON Schema of scenes and studies, for editors", "assay schema > scene.schema.json",
          add_schema_arguments};
}

}  // namespace assay::drivers
