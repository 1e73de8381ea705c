// SPDX-License-Identifier: BSD-3-Clause
// The picture that answers a study's question, error against cost, both logarithmic; and what it shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/picture/drawing.hpp"
#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// What stands on the axis of cost.
enum class CostAxis {
  cost,  ///< the study's figure
  work,  ///< particle-steps, the same on every machine
};

/// A case that completed.
struct WorkPoint {
  std::size_t index = 0;  ///< of the case
  double cost = 0, error = 0;
};

struct WorkCurve {
  std::string name;
  std::vector<std::vector<WorkPoint>> runs;  ///< interrupted by resolutions that did not complete
  std::optional<std::size_t> color;          ///< of the palette; of at most seven series on the front
  bool exact = false;                        ///< a case of it uses the exact solution, or cannot be on a front
};

/// A case that did not complete.
struct WorkDeath {
  std::size_t index = 0;
  Figure cost;  ///< reached
  std::optional<std::size_t> color;
};

/// A whole digit of accuracy, and what it costs.
struct WorkLevel {
  double error = 0;
  Figure cost;
  Figure factor;  ///< to the level before
};

struct WorkPrecision {
  std::vector<WorkCurve> curves;
  std::vector<WorkPoint> front;  ///< by cost
  std::vector<WorkDeath> deaths;
  std::vector<WorkLevel> levels;
};

/// Cases whose cost or error cannot stand on a logarithmic axis are left out.
WorkPrecision work_precision(const StudyFindings& findings, CostAxis axis);

/// Of a point or a cross: what it is, in a sentence.
std::string tip_of(const StudyFindings& findings, const StudyCase& one);

/// The front as a broad band; series on it in colours, named at their curves; the others thin and grey, named where a
/// pointer rests on them; cases that did not complete as crosses above, at the cost that they reached (at the left
/// end without one); guides at whole digits of accuracy with what each costs.
Drawing work_precision_plot(const StudyFindings& findings, CostAxis axis = CostAxis::cost);

}  // namespace assay::drivers
