// SPDX-License-Identifier: BSD-3-Clause
// `assay export`: a folder with all that another code needs to run a scene and to be judged.
#include "drivers/export/export.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "drivers/verbs/verbs.hpp"

namespace assay::drivers {

namespace {

std::string words_of_targets() {
  std::string words;
  for (const Target& each : targets()) words += (words.empty() ? "" : " ") + std::string(each.name);
  return words;
}

Act add_export_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<ExportOptions>();
  add_scene(verb, *given);
  add_value(verb, "--to", given->target, "TARGET", "code or format to write for", words_of_targets())->required();
  add_value(verb, "--grids", given->grids, "H,...", "spacings of the grids [m] (default: three)");
  verb.app.add_flag("--quasi-static", given->quasi_static, "forces without inertia, for quasi-static codes");
  add_out(verb, given->out, "DIR", "folder for the files (default: results/SCENE_TARGET)");
  return [given](Verbosity verbosity) {
    given->verbosity = verbosity;
    if (given->out.empty()) given->out = "results/" + stem_of_input(given->scene) + "_" + given->target;
    return export_scene(*given);
  };
}

void say(const ExportedProblem& problem, const Target& target, const std::string& folder) {
  std::string text = wrapped(std::string(target.name) + ": " + target.doc, "", "  ");
  for (const ExportedGrid& grid : problem.grids)
    text += "  " + grid.folder + ": " + grouped_text(static_cast<std::int64_t>(grid.size())) +
            (target.seeds == SeedPlace::nodes ? " nodes\n" : " particles\n");
  for (const std::string& remark : problem.remarks) text += wrapped(remark, "  ", "  ");
  print(text + wrapped("written to " + folder + ", begin with its README.md", "", "  "));
}

}  // namespace

int export_scene(const ExportOptions& options) {
  forget_inputs();
  const Target& target = target_of(options.target);
  watch_interrupts();
  try {
    const ExportedProblem problem = export_problem(options, target);
    const std::map<std::string, std::string> files = folder_of(problem, target);
    OutputFolder folder(options.out, mapped(files, [](const auto& file) { return file.first; }));
    folder.keep_inputs();
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
    folder.commit();
    if (!options.quiet()) say(problem, target, options.out);
    return 0;
  } catch (const MaterialFailure& failure) {
    Result result;
    record_failure(failure, result);
    std::fprintf(stderr, "%s\n", one_line(result.reason).c_str());
    return 1;
  }
}

Verb verb_export() {
  return {82, "write a scene for another code to run", "assay export scene.yaml --to csv --grids .1,.05,.025 -o run",
          add_export_arguments};
}

}  // namespace assay::drivers
