// SPDX-License-Identifier: BSD-3-Clause
// `assay run`: from a scene to a verdict.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/findings.hpp"
#include "drivers/output/errors_csv.hpp"
#include "drivers/output/junit.hpp"
#include "drivers/output/report.hpp"
#include "drivers/picture/author_units.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay::drivers {

namespace {

/// The plastic rim, with a warning where the grid is too coarse for it.
void record_rim(const PosedScene& problem, const Response& response, Result& result) {
  const auto* vortex = problem.scene.motion.as<Vortex>();
  if (!vortex) return;
  result.rim = rim_of(response, *vortex, problem.scene.grid->spacing, problem.scene.time.end);
  if (const std::string words = result.rim ? narrow_rim_sentence(*result.rim, problem.scene.units) : ""; !words.empty())
    warn(words);
}

void record_response(const PosedScene& problem, const Response& response, double seconds, Result& result) {
  record_sheet(problem.scene, response, seconds, result);
  if (problem.scene.motion->polar() && response.sheet())
    result.sheet->error_b =
        force_error(problem.scene.motion, problem.scene.material.density, *response.sheet(), problem.scene.time.end);
  record_rim(problem, response, result);
}

/// Builds the exact solution, steps, and leaves snapshots and pictures in the folder. life: of the run.
template <int Dim>
std::vector<ReportPicture> simulate_into(ProblemIn<Dim>& problem, const RunOptions& options, const Stopwatch& life,
                                         OutputFolder& folder, Result& result) {
  const Stopwatch of_response;
  ExactSolutionPtr exact;
  if (const std::string words = long_motion_sentence(problem); !words.empty() && !options.quiet()) warn(words);
  if (problem.compared) {
    exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end,
                              {.threads = problem.setup.threads, .quiet = options.quiet()});
    if (exact->response()) record_response(problem, *exact->response(), of_response.seconds(), result);
  }
  const double response_s = of_response.seconds();
  Snapshots snapshots(problem, folder);
  Progress progress(problem.scene.title, options.quiet());
  result.setup_s = life.seconds();
  simulate(problem, exact, snapshots, progress, result);
  if (result.outcome != "completed") result.last_good = snapshots.leave_last_good(exact);
  if (result.outcome == "unstable") result.advice = advice_after_death(problem, result.reason);
  if (result.outcome == "completed")
    result.advice = advice_after_large_error(problem, result.error.relative.value_or(0));
  if (exact) record_source(problem.scene, *exact, response_s, result);
  result.peak_rss_bytes = peak_memory();  // before pictures are drawn
  if (problem.scene.output.tractions) result.tractions = traction_table(problem, result, folder, options.quiet());
  std::vector<ReportPicture> pictures;
  for (auto& picture : snapshots.finish()) pictures.push_back({picture.caption, std::move(picture.png)});
  return pictures;
}

/// Whether the motion may be run: it is a stable solution for the model, or the scene allows otherwise.
bool admitted(const PosedScene& problem, bool quiet, Result& result) {
  const Scene& scene = problem.scene;
  if (!problem.compared) return true;  // then the body does not move as the motion says
  result.screen = screen_of(scene, *problem.material, scene.time.end, quiet);
  if (result.screen->unjudged > 0) warn(screen_sentence(*result.screen, scene.units));
  const std::string sentence = refusal_sentence(scene, *result.screen, problem.material->name());
  if (sentence.empty()) return true;
  result.outcome = "refused";
  result.reason = sentence;
  return false;
}

/// The files beside the snapshots that need no verdict.
void write_history(const Scene& scene, const Result& result, OutputFolder& folder) {
  folder.write("errors.csv", errors_csv(result.history));
  if (scene.output.pictures && !result.history.empty())
    folder.write("error_history.png", png(in_units(error_history_plot(result.history), scene.units)));
}

/// Report and verdict. Returns the text of result.json.
std::string write_verdict(const Scene& scene, const Result& result, std::vector<ReportPicture> pictures,
                          OutputFolder& folder) {
  const std::string resolved = resolved_yaml(scene);
  folder.write("resolved.yaml", resolved);
  if (scene.output.report)
    folder.write("report.html", report_html(result, {scene.motion->period(), std::move(pictures), resolved}));
  std::string json = result_json(result);
  folder.write("result.json", json);
  return json;
}

/// Poses the scene's problem, and completes the scene by it. Returns whether it is to be run: not where the material
/// fails on the way, or the motion is not admitted.
template <int Dim>
bool pose(const RunOptions& options, Scene& scene, std::optional<ProblemIn<Dim>>& problem, Result& result) {
  try {
    problem = assemble<Dim>(scene, options.threads);
    scene = problem->scene;
    result.subject = problem->subject();
    result.uses_exact_solution = problem->setup.uses_exact_solution();
    for (const std::string& sentence : warnings_of(*problem)) result.warnings.push_back(sentence);
    result.provenance.material = material_provenance(*problem->material, problem->library);
    return admitted(*problem, options.quiet(), result);
  } catch (const MaterialFailure& failure) {
    record_failure(failure, result);
    return false;
  }
}

Act add_run_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<RunOptions>();
  const auto threads = std::make_shared<std::string>();
  add_scene(verb, *given);
  add_value(verb, "--threads", *threads, "N", "number of threads (default: 1)", "1 2 4 8 16");
  add_results(verb, *given);
  add_junit(verb, given->junit, given->junit_name, "outcome and expectations as JUnit XML, for CI");
  return [given, threads](Verbosity verbosity) {
    require_junit_of_name("run", given->junit, given->junit_name);
    given->out = results_folder(given->out, given->scene);
    given->threads = count_in("--threads", *threads, 1);
    given->verbosity = verbosity;
    return run(*given);
  };
}

template <int Dim>
int run_in(const RunOptions& options, Scene scene, const Stopwatch& life) {
  Result result = result_for(scene);
  std::optional<ProblemIn<Dim>> problem;
  const bool runs = pose(options, scene, problem, result);
  refuse_input_as_output(options.junit, "--junit");
  OutputFolder folder(options.out);
  folder.keep_inputs();
  std::vector<ReportPicture> pictures;
  try {
    if (runs) pictures = simulate_into(*problem, options, life, folder, result);
  } catch (const MaterialFailure& failure) {
    record_failure(failure, result);
  }
  if (problem) record_process(*problem->material, result);
  leave_replay(scene, folder, result);
  leave_replay_scene(scene, folder, result);
  write_history(scene, result, folder);
  close_accounts(life, result);
  result.expect = judge(scene.expect, result);
  const std::string json = write_verdict(scene, result, std::move(pictures), folder);
  stop_if_interrupted();
  folder.commit();
  const std::string junit = options.junit.empty() ? "" : run_junit(result, options, life.seconds());
  const std::string text = verdict_text(result, options.out, options.verbosity == Verbosity::verbose);
  tell(said_of(result, options, text), {{options.json ? "-" : "", json, true}, {options.junit, junit}});
  return exit_status(result);
}

}  // namespace

int run(const RunOptions& options) {
  forget_inputs();
  const Stopwatch life;
  const Scene scene = read_scene(options.scene, options.sets);
  refuse_junit_in_the_way(options);
  require_junit_folder(options.junit, options.out);
  watch_interrupts();
  return in_dimension(scene, [&](auto dimension) { return run_in<dimension.value>(options, scene, life); });
}

Verb verb_run() {
  return {60, "run a scene and measure its errors",
          "assay run configs/paper/vortex_cpdi.yaml -o results/vortex \\\n"
          "      --set grid.spacing=0.025 --set 'expect={}'",
          add_run_arguments};
}

}  // namespace assay::drivers
