// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/findings/findings.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/process/process_watch.hpp"
#include "adapters/worker/remote_table.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/check/replay.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/supervisor.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

Result result_for(const Scene& scene) {
  Result result;
  result.title = scene.title;
  result.units = scene.units;
  result.provenance = build_information();
  result.provenance.scene_sha256 = scene.sha256;
  return result;
}

void record_sheet(const Scene& scene, const Response& response, double seconds, Result& result) {
  const Sheet* sheet = response.sheet();
  if (!sheet) return;
  SheetFigures figures{sheet->points(), sheet->error_tau(), sheet->error_dtau(), {}, seconds};
  figures.cached = sheet->restored();
  figures.asked = scene.force.tolerance;
  result.sheet = figures;
  if (!sheet->restored()) result.material_calls += sheet->material_calls();
}

void record_source(const Scene& scene, const ExactSolution& exact, double seconds, Result& result) {
  const auto source = exact.source();
  if (!source) return;
  SheetFigures figures;
  figures.points = source->points;
  figures.error_tau = source->error;
  figures.asked = scene.force.tolerance;
  figures.along = exact.response() ? grouped_text(source->points) + " " + source->what : source->what;
  if (!source->by.empty()) {
    figures.along += ", by " + source->by + " at each of its nodes";
    figures.wall_s = seconds;
  }
  result.sheet = figures;
  result.material_calls += source->material_calls;
}

std::string material_provenance(const Material& material, const std::string& library) {
  const char* version = material.table().version;
  const std::string who = material.name() + (version ? " " + one_line(version, 80) : "");
  if (library.empty()) return who + ", built in";
  return who + ", " + library + ", sha256 " + hash_of_library(library);
}

void record_failure(const MaterialFailure& failure, Result& result) {
  stop_if_interrupted();  // it may have failed because nobody waited for it
  result.outcome = "material_failed";
  result.reason = failure.what();
  if (failure.too_accurate) result.advice = "force.tolerance: 1e-4, which asks for less accuracy of the response";
  if (!std::isnan(failure.xi)) {
    result.reason += ": on the baseline path at xi = " + rounded_text(failure.xi, 6) +
                     ", t = " + result.units.text(failure.t, "s", 6);
    result.t = failure.t;
  }
  if (failure.step) result.failed_step = std::make_shared<const FailedStep>(*failure.step);
}

void record_process(const Material& material, Result& result) {
  const adapters::WorkerMarks marks = adapters::marks_of(&material.table());
  const adapters::Habits habits = marks.habits | supervised_habits();
  const std::string words = adapters::habit_words(habits);
  if (!words.empty()) result.warnings.push_back("the model " + words);
  result.disturbed = (habits & ~adapters::any_written_input) != adapters::no_habit;
  result.printed = marks.printed;
  result.hand_overs = marks.hand_overs;
  result.wake_ups = marks.wake_ups;
}

void leave_replay(const Scene& scene, OutputFolder& folder, Result& result) {
  if (!result.printed.empty()) folder.write(material_log, result.printed);
  if (!result.failed_step && !result.disturbed) return;
  try {
    const ResolvedMaterial material = resolve_material(scene.material);
    Replay replay = result.failed_step ? replay_of(material, *result.failed_step, result.reason)
                                       : replay_of(material, {}, result.warnings.back());
    if (!result.failed_step) replay.test = process_test;
    folder.write("replay.yaml", replay_yaml(replay, scene.material.isolation));
    result.replay = "replay.yaml";
  } catch (const InputError& error) {  // it does not live so long once more
    result.warnings.push_back(std::string("no replay.yaml is left: ") + error.what());
  }
}

void leave_replay_scene(const Scene& given, OutputFolder& folder, Result& result) {
  if (result.outcome == "completed" || !result.steps || !result.dt || !result.t) return;
  constexpr double shown_steps = 20, most_to_end = 5e4;  // what a scene may ask for is twice that
  Scene scene = given;
  scene.output = {.errors = given.output.errors, .particles = 0, .pictures = false};
  scene.output.each_step_from = std::max(0.0, *result.t - shown_steps * *result.dt);
  if (scene.time.end - *scene.output.each_step_from > most_to_end * *result.dt) {
    scene.time = TimeChoice();
    scene.time.end = static_cast<double>(*result.steps + 1) * *result.dt;
    scene.time.step = *result.dt;
  }
  scene.expect = expected_again(result);
  const std::string name = "replay_scene.yaml";
  folder.write(name, resolved_yaml(scene));
  if (result.replay.empty()) result.replay = name;
}

void close_accounts(const Stopwatch& life, Result& result) {
  if (result.wall_s == 0) result.setup_s = life.seconds();
  result.finish_s = std::max(0.0, life.seconds() - result.setup_s - result.wall_s);
  result.cpu_s = cpu_seconds();
}

int exit_status(const Result& result) {
  const bool all_hold = std::ranges::all_of(result.expect, &ExpectationOutcome::holds);
  const bool outcome_expected = std::ranges::count(result.expect, "outcome", &ExpectationOutcome::key) > 0;
  return all_hold && (outcome_expected || result.outcome == "completed") ? 0 : 1;
}

}  // namespace assay::drivers
