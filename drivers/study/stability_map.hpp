// SPDX-License-Identifier: BSD-3-Clause
// Which cases of a study hold and which die: methods by resolution.
#pragma once

#include <string>
#include <vector>

#include "drivers/picture/drawing.hpp"
#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// Colours are the same on any page; every cell says in words what its colour says.
struct StabilityCell {
  const StudyCase* of = nullptr;  ///< null where the study has no such case
  std::string text;               ///< "1.2 %", "unstable"
  std::string detail;             ///< "t = 0.31 s"
  Color background = rgb(0xffffff), ink = rgb(0x1a1a1a);
};

struct StabilityRow {
  std::string name;
  std::vector<StabilityCell> cells;  ///< one a column
};

struct StabilityMap {
  std::string row_name, column_name;
  std::vector<std::string> columns;
  std::vector<StabilityRow> rows;
};

/// Columns: the refined key, else the second axis, else one. Rows: all other axes. Blue is the darker the smaller the
/// error; what died is orange, what was refused or stopped is grey. The findings must outlive the map.
StabilityMap stability_map(const StudyFindings& findings);

/// A table of HTML with the reasons.
std::string stability_table(const StabilityMap& map);

Drawing stability_picture(const StabilityMap& map);

}  // namespace assay::drivers
