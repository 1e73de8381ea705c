// SPDX-License-Identifier: BSD-3-Clause
// One case of a study and what it found.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "drivers/result/fields.hpp"
#include "drivers/result/result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/study/plan/study.hpp"

namespace assay::drivers {

/// The clock of the repeats of a timed case; medians and spreads of them are among the case's figures.
struct ClockReadings {
  bool alone = false;          ///< nothing of the study ran beside it
  std::vector<double> step_s;  ///< processor time of the steps alone [s]
  std::vector<double> cpu_s;   ///< of the whole process [s]
  std::vector<double> wall_s;  ///< of the step loop [s]
  std::vector<double> others;  ///< cores that other programs kept busy meanwhile [1]
  std::string machine;         ///< "AMD EPYC, 2 cores"

  ASSAY_FIELDS(alone, step_s, cpu_s, wall_s, others, machine)
};

/// One case. Figures that were not reached are absent.
struct StudyCase {
  std::size_t number = 0;  ///< from 1, in the order of the study
  std::string key;         ///< hash of resolved scene, binary and libraries: its folder is cases/KEY; empty: n/a
  std::vector<AxisValue> values;
  std::string label;                ///< "CPDI, FLIP, grid.spacing=0.05"
  std::string series;               ///< the label without the axis of resolution; "all" where there is no other axis
  Figure resolution;                ///< value of the refined key, such as h [m]
  std::string outcome = "missing";  ///< completed, unstable, material_failed, refused, n/a, crashed, stopped, missing
  std::string reason;               ///< one sentence where not completed
  bool budget = false;              ///< only there for the error budget: in no series, order or front
  std::map<std::string, FlatValue> figures;  ///< of result.json, by dotted key
  Figure error;                              ///< the study's figure of error; absent where not completed
  Figure cost;                               ///< the study's figure of cost, median of the repeats where it is a time
  Figure cost_spread;                        ///< half the range of the repeats over the median; absent of one
  Figure work;                               ///< particle-steps
  bool eligible = false;                     ///< completed, with error and cost, and does not use the exact solution
  bool on_front = false;
  ClockReadings clock;
  std::vector<PassFigures> passes;
  std::vector<std::array<double, 2>> history;  ///< t [s], L2 error of the displacement [m]

  bool completed() const { return outcome == "completed"; }

  ASSAY_FIELDS(number, key, values, label, series, resolution, outcome, reason, budget, error, cost, cost_spread, work,
               eligible, on_front, clock, figures, passes, history)
};

/// What result.json says under that key; null where there is nothing of that type.
template <class T>
const T* value_in(const std::map<std::string, FlatValue>& figures, const std::string& key) {
  const auto found = figures.find(key);
  return found == figures.end() ? nullptr : std::get_if<T>(&found->second);
}

}  // namespace assay::drivers
