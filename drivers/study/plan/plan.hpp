// SPDX-License-Identifier: BSD-3-Clause
// The cases of a study, each with its scene, ready to be run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/result/result.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/study/plan/study.hpp"

namespace assay::drivers {

/// One combination: where it stands on every axis that it has a value of, and what that sets.
struct Combination {
  std::vector<AxisValue> values;
  std::vector<Setting> settings;
};

/// All that the study samples and does not exclude: the full product with the last axis fastest, the list, or a Latin
/// hypercube, in which each axis is cut into as many equal parts as there are cases and each part is taken once. The
/// same study gives the same combinations everywhere. Throws InputError where there are none or too many.
std::vector<Combination> combinations_of(const Study& study);

inline constexpr std::size_t most_combinations = 100000;

/// Of the resolved scene, the files that it names (the material's library and description, a table of the motion), what
/// a material that is not built in answers along a short way, the number of threads, and this program with the shared
/// libraries that it runs with: 32 hexadecimal digits. Throws InputError where a file cannot be read.
std::string case_key(const Scene& scene, const std::string& resolved, int threads);

struct PlannedCase {
  std::size_t number = 0;  ///< from 1
  std::vector<AxisValue> values;
  std::string label, series;
  Figure resolution;  ///< value of the refined key
  int threads = 1;
  std::string yaml;                 ///< the text of its scene, every default written out
  std::string key;                  ///< 32 hexadecimal digits; empty where the case cannot be
  std::string invalid;              ///< why it cannot be, one line
  double particle_steps = 0;        ///< expected
  bool timed = false;               ///< runs alone, and again
  std::optional<std::size_t> base;  ///< of a case that refines one source of another's error: that one's index
  std::size_t source = 0;           ///< and the source's index in the study's budget
};

struct Plan {
  Study study;
  std::vector<PlannedCase> cases;
};

/// Reads every scene as `assay run` would. Throws InputError where one cannot be, unless the study skips such.
/// `progress` is told the share that is done.
Plan plan_of(Study study, const std::function<void(double)>& progress = {});

}  // namespace assay::drivers
