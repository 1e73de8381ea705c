// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a study and what they show: which cases hold and which die, methods by resolution; and what accuracy
// costs, error against cost, both logarithmic.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/picture/drawing.hpp"
#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// Colours are the same on any page; every cell says in words what its colour says.
struct StabilityCell {
  std::vector<const StudyCase*> of;  ///< empty where the study has no such case, many where the map leaves axes out
  std::string text;                  ///< "1.2 %", "unstable"; of many "297 of 300"
  std::string detail;                ///< "t = 0.31 s"; of many "up to 0.013 m"
  Color background = rgb(0xffffff), ink = rgb(0x1a1a1a);
};

/// The case whose outcome a cell shows: of many the first that did not complete. Null of an empty cell.
const StudyCase* telling_case(const StabilityCell& cell);

struct StabilityRow {
  std::string name;
  std::vector<StabilityCell> cells;  ///< one a column
};

struct StabilityMap {
  std::string row_name, column_name;
  std::vector<std::string> columns;
  std::vector<StabilityRow> rows;
};

/// Columns: the refined key, else the second axis, else one. Rows: all other axes. An axis of very many values, as
/// samples have, is left out: cells then count the cases that completed. Blue is the darker the smaller the
/// error; what died is orange, what was refused or stopped is grey. The findings must outlive the map.
StabilityMap stability_map(const StudyFindings& findings);

/// A cell of a table of HTML, with the reason.
std::string stability_cell(const StabilityCell& cell);

Drawing stability_picture(const StabilityMap& map);

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
