// SPDX-License-Identifier: BSD-3-Clause
// `assay judge`: the output of another code against a scene's exact motion.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "drivers/command_line/verb.hpp"
#include "drivers/judge/judging.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/verbs/verbs.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

std::vector<double> spacings_of(const std::string& given, std::size_t runs) {
  std::vector<double> h;
  if (given.empty()) return h;
  for (const std::string& part : split(given, ',')) {
    const auto value = parse_number(stripped(part));
    if (!value || !(*value > 0)) throw InputError({}, "--h", "'" + part + "' is no spacing above 0");
    h.push_back(*value);
  }
  if (h.size() != runs)
    throw InputError({}, "--h", std::to_string(h.size()) + " spacings for " + std::to_string(runs) + " runs");
  return h;
}

Act add_judge_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<JudgeOptions>();
  add_scene(verb, *given);
  verb.app.add_option("RUN", given->runs, "files or folders, one for each grid")
      ->required()
      ->expected(-1)
      ->type_name("");
  add_value(verb, "--map", given->map, "MAP", "YAML of names, units and times, or a code's name");
  add_value(verb, "--h", given->spacings, "H,...", "spacing of the grid of each run [m]");
  add_value(verb, "--order", given->order, "P", "least order between the two finest grids");
  add_results(verb, *given, "judge.json");
  add_junit(verb, given->junit, given->junit_name, "verdict as JUnit XML, for CI");
  return [given](Verbosity verbosity) {
    require_junit_of_name("judge", given->junit, given->junit_name);
    if (given->out.empty()) given->out = "results/judge_" + stem_of_input(given->scene);
    given->verbosity = verbosity;
    return judge_runs(*given);
  };
}

}  // namespace

int judge_runs(const JudgeOptions& options) {
  forget_inputs();
  const Stopwatch life;
  const Scene scene = read_scene(options.scene, options.sets);
  watch_interrupts();
  JudgeTask task;
  task.runs = options.runs, task.map_file = options.map, task.quiet = options.quiet();
  task.h = spacings_of(options.spacings, options.runs.size());
  task.expected = expected_of_any_code(scene, false);
  if (!options.order.empty()) {
    const auto order = parse_number(options.order);
    if (!order) throw InputError({}, "--order", "'" + options.order + "' is no number");
    Expectation& line = task.expected.emplace_back();
    line.key = last_order_key, line.op = Expectation::Operator::above, line.number = *order;
  }
  if (!options.map.empty()) task.map = read_judge_map(options.map);
  OutputFolder folder(options.out, judge_files());
  folder.keep_inputs();
  const JudgeFindings findings = findings_of(scene, task);
  const std::string json = write_findings(findings, scene, folder);
  folder.write("judge.json", json);
  folder.commit();
  const std::string name = options.junit_name.empty() ? stem_of_input(options.scene) : options.junit_name;
  const std::string junit = options.junit.empty() ? "" : judge_junit(findings, name, life.seconds());
  const std::string text = options.quiet() && findings.good ? "" : judge_text(findings, options.out);
  tell(text, {{options.json ? "-" : "", json, true}, {options.junit, junit}});
  return findings.good ? 0 : 1;
}

Verb verb_judge() {
  return {85, "judge the output of another code",
          "assay judge scene.yaml run_10cm.csv run_5cm.csv --h .1,.05 -o results/judge", add_judge_arguments};
}

}  // namespace assay::drivers
