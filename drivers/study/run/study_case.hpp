// SPDX-License-Identifier: BSD-3-Clause
// One case of a study and what it found.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

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

  static void fields(auto& self, auto& archive) {
    archive("alone", self.alone);
    archive("step_s", self.step_s);
    archive("cpu_s", self.cpu_s);
    archive("wall_s", self.wall_s);
    archive("others", self.others);
    archive("machine", self.machine);
  }
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

  static void fields(auto& self, auto& archive) {
    archive("number", self.number);
    archive("key", self.key);
    archive("values", self.values);
    archive("label", self.label);
    archive("series", self.series);
    archive("resolution", self.resolution);
    archive("outcome", self.outcome);
    archive("reason", self.reason);
    archive("budget", self.budget);
    archive("error", self.error);
    archive("cost", self.cost);
    archive("cost_spread", self.cost_spread);
    archive("work", self.work);
    archive("eligible", self.eligible);
    archive("on_front", self.on_front);
    archive("clock", self.clock);
    archive("figures", self.figures);
    archive("passes", self.passes);
    archive("history", self.history);
  }
};

/// What result.json says under that key; null where there is nothing of that type.
template <class T>
const T* value_in(const std::map<std::string, FlatValue>& figures, const std::string& key) {
  const auto found = figures.find(key);
  return found == figures.end() ? nullptr : std::get_if<T>(&found->second);
}

}  // namespace assay::drivers
