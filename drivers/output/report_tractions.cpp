// SPDX-License-Identifier: BSD-3-Clause
// The section of report.html that sets the algorithms of tractions side by side.
#include <cmath>

#include "drivers/output/html.hpp"
#include "drivers/output/report.hpp"
#include "drivers/picture/drawing.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using namespace html;

namespace {

using TractionRow = std::vector<std::string>;

std::string small_print(const std::string& text) { return text.empty() ? "" : element("small", text); }

/// One column a grid: of them the table's first algorithm has them all.
std::vector<const TractionRun*> grids_of(const TractionTable& table) {
  std::vector<const TractionRun*> grids;
  for (const TractionRun& run : table.runs) {
    if (run.algorithm == table.runs.front().algorithm) grids.push_back(&run);
  }
  return grids;
}

std::string grid_text(const TractionRun& run) {
  const std::string deep = run.cells[2] > 0 ? " \u00d7 " + rounded_text(run.cells[2], 4) : "";
  return rounded_text(run.cells[0], 4) + " \u00d7 " + rounded_text(run.cells[1], 4) + deep + " cells" +
         small_print("h = " + with_unit(rounded_text(run.spacing, 4), "m"));
}

/// The paper's table 1 on those of the grids that it has.
TractionRow paper_row(const std::vector<const TractionRun*>& grids) {
  constexpr struct { double cells, error; } published[] = {{2, 0.0733}, {4, 0.0724}, {8, 0.0724}};
  TractionRow row{"the paper's table 1"};
  for (const TractionRun* grid : grids) {
    row.push_back(none);
    for (const auto& entry : published) {
      if (std::abs(grid->cells[0] - entry.cells) < 1e-6) row.back() = figure(entry.error);
    }
  }
  return row;
}

std::string name_of_row(const TractionRun& run) {
  const std::string name = run.algorithm + (run.form.empty() ? "" : ", " + run.form + " form");
  return (run.own ? element("b", name) : name) + small_print(run.own ? "as in this scene" : "") +
         small_print(run.exact ? "uses the exact solution" : "");
}

std::string entry_for(const TractionRun& run) {
  if (run.outcome == "completed") return figure(run.l2_end) + small_print("max. " + figure(run.l2_max));
  const std::string when = run.t ? "at t = " + with_unit(rounded_text(*run.t, 3), "s") : "";
  return "<td class=\"fails\">" + escaped(run.outcome) + small_print(when) + "</td>";
}

std::string caption_line(const std::string& text) { return "<p><small>" + text + "</small></p>\n"; }

std::string traction_caption(const TractionTable& table) {
  std::string text =
      "<code>undeformed_edges</code> multiplies a traction per current area by the initial length of the edge. If the "
      "motion changes that length, the force is wrong, and a finer grid does not reduce this error. ";
  if (table.of_paper) {
    text +=
        "The errors of the paper do not fall with h either, and the paper asks for the cause in its own algorithm of "
        "tractions: with the initial length, half the force is missing at the end on the faces along the stretch. ";
  }
  text +=
      "With <code>particles</code>, the force acts half a particle inside the surface, which is an error of first "
      "order in h. <code>virtual_stress</code> gets the exact stress: it tests data and transfer, not the quadrature "
      "of tractions.";
  return caption_line(
             "L<sub>2</sub> error of the displacement at the end, and its maximum over time [m]. This scene's run is "
             "the last column of the row in bold; the others took " +
             rounded_text(table.wall_s, 2) + "\u202fs.") +
         caption_line(text);
}

}  // namespace

std::string tractions_section(const Result& result) {
  if (!result.tractions || result.tractions->runs.empty()) return {};
  const TractionTable& compared = *result.tractions;
  const auto grids = grids_of(compared);
  TractionRow head{"tractions by"};
  for (const TractionRun* grid : grids) head.push_back(grid_text(*grid));
  std::vector<TractionRow> rows;
  if (compared.of_paper) rows.push_back(paper_row(grids));
  for (std::size_t k = 0; k < compared.runs.size(); ++k) {
    if (k % grids.size() == 0) rows.push_back({name_of_row(compared.runs[k])});
    rows.back().push_back(entry_for(compared.runs[k]));
  }
  return section("Tractions side by side", table(head, rows) + traction_caption(compared));
}

}  // namespace assay::drivers
