// SPDX-License-Identifier: BSD-3-Clause
// The cases of a study, each with its scene, ready to be run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/study/study.hpp"

namespace assay::drivers {

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
