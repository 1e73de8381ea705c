// SPDX-License-Identifier: BSD-3-Clause
// `assay explain`: what a run of a scene consists of. No particle moves.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "drivers/command_line/verb.hpp"
#include "drivers/explain/composition.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

Act add_explain_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<ExplainOptions>();
  add_scene(verb, *given);
  verb.app.add_flag("--json", given->json, "as JSON");
  return act_of(given, explain);
}

template <int Dim>
int explain_in(const ExplainOptions& options, const Scene& scene) {
  const bool quiet = options.quiet() || options.json;
  try {
    const ProblemIn<Dim> problem = assemble<Dim>(scene, 1);
    for (const std::string& sentence : quiet ? std::vector<std::string>() : warnings_of(problem)) warn(sentence);
    const ScreenFigures screen = screen_of(problem.scene, *problem.material, problem.scene.time.end, quiet);
    ExactSolutionPtr exact;
    const bool refused = !refusal_sentence(problem.scene, screen, problem.material->name()).empty();
    if (problem.compared && !refused) {  // minutes for the sheet of a run that would not begin
      exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end, {.quiet = quiet});
    }
    options.json ? print_json(explanation_json(problem, exact.get(), screen))
                 : print(explanation(problem, exact.get(), screen));
    return 0;
  } catch (const MaterialFailure& failure) {
    Result result;
    result.units = scene.units;
    record_failure(failure, result);
    const std::string advice = result.advice.empty() ? "" : "; to try: " + result.advice;
    std::fprintf(stderr, "%s\n", one_line(result.reason + advice).c_str());
    return 1;
  }
}

}  // namespace

int explain(const ExplainOptions& options) {
  const Scene scene = read_scene(options.scene, options.sets);
  return in_dimension(scene, [&](auto dimension) { return explain_in<dimension.value>(options, scene); });
}

Verb verb_explain() {
  return {90, "what a run would do and cost; nothing is run", "assay explain configs/paper/vortex_cpdi.yaml --json",
          add_explain_arguments};
}

}  // namespace assay::drivers
