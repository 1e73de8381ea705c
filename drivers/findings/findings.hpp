// SPDX-License-Identifier: BSD-3-Clause
// What is found on the way enters the result; the result becomes text, JUnit's XML and an exit status.
#pragma once

#include <string>

#include "drivers/findings/run_options.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/material/material_failure.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

/// In which nothing is found yet.
Result result_for(const Scene& scene);

/// Size and error of the sheet, seconds it took; nothing where the response is a closed form.
void record_sheet(const Scene& scene, const Response& response, double seconds, Result& result);

/// What stands behind a stress that no sheet has, once the run is over: number and error of histories, or size and
/// error of the series of the unit box and the seconds in which its size was found.
void record_source(const Scene& scene, const ExactSolution& exact, double seconds, Result& result);

/// "neo_hookean 1.0, built in" or "soft_clay 0.3, /path/libclay.so, sha256 ...". Throws InputError where the library
/// can no longer be read.
std::string material_provenance(const Material& material, const std::string& library);

/// Outcome `material_failed` with point, time and the material's words.
void record_failure(const MaterialFailure& failure, Result& result);

/// What a material that runs apart has printed, and a warning of what it has done to its processes.
void record_process(const Material& material, Result& result);

/// The file of what was printed.
inline constexpr const char* material_log = "material.log";

/// replay.yaml in the folder, its name in the result: where the result knows the step at which the material failed, or
/// warns of its material. Beside it what the material has printed.
void leave_replay(const Scene& scene, OutputFolder& folder, Result& result);

/// Leaves replay_scene.yaml of a run that did not reach its end: the same steps, with a snapshot of each of the last.
void leave_replay_scene(const Scene& scene, OutputFolder& folder, Result& result);

/// finish_s and cpu_s: what a verb has taken since `life` began and is not named yet. Set-up where it came to no work.
void close_accounts(const Stopwatch& life, Result& result);

/// 0: all that was expected holds; 1: it does not, or the run did not complete and nobody expected that.
int exit_status(const Result& result);

/// Outcome and verdict, expectations that fail, the reason; then error figures, speed, [the profile,] expectations that
/// hold, and where the results are.
std::string verdict_text(const Result& result, const std::string& folder, bool with_profile = false);

/// What a verb says of a result: `text`; with --quiet only, where it ends with 1, the first part of the verdict, down
/// to the reason.
std::string said_of(const Result& result, const SceneOptions& options, const std::string& text);

/// Warnings, and the files in the result's folder that tell more of the material.
std::string process_lines(const Result& result, const std::string& folder);

/// How long it has taken: set-up, the work, and what came behind it.
std::string times_text(const Result& result, const std::string& work);

/// Size, time and errors of the response, and what was asked where that is missed.
std::string sheet_text(const SheetFigures& sheet);

/// The expectations that hold or that fail, a line each, "holds" or "FAILS" first.
std::string expectations_text(const Result& result, bool that_hold);

/// JUnit's XML: a test of the outcome, which takes `seconds`, and one for each expectation. The exit status is 0
/// exactly where no test fails. A run that was refused is an error.
std::string run_junit(const Result& result, const RunOptions& options, double seconds);

/// Throws InputError where the file would take the place of another that the run reads or writes.
void refuse_junit_in_the_way(const RunOptions& options);

}  // namespace assay::drivers
