// SPDX-License-Identifier: BSD-3-Clause
// Which cases of a study hold and which die: methods by resolution.
#pragma once

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

}  // namespace assay::drivers
