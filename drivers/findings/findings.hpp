// SPDX-License-Identifier: BSD-3-Clause
// What is found on the way enters the result; the result becomes an exit status.
#pragma once

#include "drivers/output/output_folder.hpp"
#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

/// Size and error of the sheet, seconds it took; nothing where the response is a closed form.
void record_sheet(const Scene& scene, const Response& response, double seconds, Result& result);

/// What stands behind a stress that no sheet has, once the run is over: number and error of histories, or size and
/// error of the series of the unit box and the seconds in which its size was found.
void record_source(const Scene& scene, const ExactSolution& exact, double seconds, Result& result);

/// What the sheet's error does to the body force of a polar motion.
void record_force_error(const Scene& scene, const Response& response, Result& result);

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

}  // namespace assay::drivers
