// SPDX-License-Identifier: BSD-3-Clause
// From a scene and the runs of another code to findings, and their files.
#pragma once

#include <string>
#include <vector>

#include "drivers/judge/judge_findings.hpp"
#include "drivers/output/output_folder.hpp"
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

struct JudgeTask {
  std::vector<std::string> runs;  ///< files or folders, one for each grid
  JudgeMap map;
  std::string map_file;               ///< for messages
  std::vector<double> h;              ///< of each run [m]; empty: the distance between particles
  std::vector<Expectation> expected;  ///< of orders, and of errors of the finest run
  bool quiet = false;
};

/// The lines of the scene's `expect:` that hold for any code: of orders; where `all`, of errors too, as in a standard
/// set.
std::vector<Expectation> expected_of_any_code(const Scene& scene, bool all);

/// Throws InputError, MaterialFailure, Interrupted.
JudgeFindings findings_of(Scene scene, const JudgeTask& task);

/// Names of the files that the folder of a judgement holds.
std::vector<std::string> judge_files();

/// Stages them all but judge.json, whose text it returns.
std::string write_findings(const JudgeFindings& findings, const Scene& scene, OutputFolder& folder);

}  // namespace assay::drivers
