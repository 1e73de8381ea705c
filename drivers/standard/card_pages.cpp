// SPDX-License-Identifier: BSD-3-Clause
// The card for the terminal, as Markdown and for the browser.
#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/standard/standard_card.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

std::string of_figure(const Figure& value, int digits = 3) { return value ? rounded_text(*value, digits) : "-"; }

constexpr double rounding_error = 1e-10;  ///< of the displacement: below it an order means nothing

std::string percent(const Figure& value) {
  if (!value) return "-";
  return *value < rounding_error ? "rounding" : rounded_text(100 * *value, 2) + " %";
}

const CardGrid* finest(const CardRow& row) { return row.was_run() ? &row.grids.back() : nullptr; }

std::string verdict_word(const CardRow& row) { return !row.was_run() ? "-" : row.good ? "good" : "fails"; }

/// id, order, error, cost, verdict; of the finest grid.
std::vector<std::string> cells_of(const CardRow& row) {
  const CardGrid* grid = finest(row);
  const bool exact = grid && grid->relative && *grid->relative < rounding_error;
  return {row.id, exact ? "-" : of_figure(row.last_order), grid ? percent(grid->relative) : "-",
          grid ? of_figure(grid->core_s, 2) : "-", verdict_word(row)};
}

const std::vector<std::string>& heads() {
  static const std::vector<std::string> all{"problem", "order", "error", "core s", "verdict"};
  return all;
}

std::string score(const CardCode& code) {
  return std::to_string(code.passed()) + " of " + std::to_string(code.rows.size()) + " good, " +
         std::to_string(code.rows.size() - code.run()) + " not run";
}

/// What is wrong, or why it was not run; empty of a good row.
std::string remark(const CardRow& row) {
  if (row.good) return {};
  return row.found;
}

constexpr const char* meaning =
    "The order is that between the two finest grids. The error is the largest L2 error of the displacement over time "
    "on "
    "the finest grid, as a share of the largest displacement. The cost in core s is seconds times cores of that run. A "
    "row without figures was not run";

/// At each underscore, on a narrow screen.
std::string may_break(std::string id) {
  for (std::size_t at = id.find('_'); at != id.npos; at = id.find('_', at + 1)) id.insert(at + 1, "<wbr>");
  return id;
}

std::string html_of_code(const CardCode& code) {
  using namespace html;
  std::vector<std::vector<std::string>> rows;
  std::string remarks;
  for (const CardRow& row : code.rows) {
    std::vector<std::string> cells;
    for (const std::string& cell : cells_of(row)) cells.push_back(may_break(escaped(cell)));
    rows.push_back(std::move(cells));
    if (const std::string why = row.was_run() ? remark(row) : std::string(); !why.empty())
      remarks += "<li>" + escaped(row.id + ": " + why) + "</li>\n";
  }
  return section(escaped(code.name),
                 element("p", escaped(score(code) + (code.machine.empty() ? "" : "; ") + code.machine)) +
                     "<div class=\"wide\">" + table(heads(), rows) + "</div>" +
                     (remarks.empty() ? "" : "<ul>\n" + remarks + "</ul>\n"));
}

/// Error over cost of each code, of a problem.
std::string html_of_cost(const StandardCard& card, std::size_t problem) {
  LinePlot plot{"", "core seconds", "error of u, of the displacement", true, true, {}};
  for (const CardCode& code : card.codes) {
    Series series{code.name, {}, {}, true, true, false};
    for (const CardGrid& grid : code.rows[problem].grids) {
      if (!grid.core_s || !grid.relative) continue;
      series.x.push_back(*grid.core_s), series.y.push_back(*grid.relative);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  if (plot.series.empty()) return {};
  return "<figure><figcaption>" + escaped(card.codes[0].rows[problem].title) + "</figcaption>" + svg(plot) +
         "</figure>\n";
}

}  // namespace

std::string card_text(const StandardCard& card) {
  std::string text;
  for (const CardCode& code : card.codes) {
    text += wrapped(code.name + ": " + score(code), "", "  ");
    text +=
        "  " + padded("problem", 30) + padded("order", 8) + padded("error", 12) + padded("core s", 10) + "verdict\n";
    for (const CardRow& row : code.rows) {
      const std::vector<std::string> cells = cells_of(row);
      text += table_line("  " + padded(cells[0], 30) + padded(cells[1], 8) + padded(cells[2], 12) +
                         padded(cells[3], 10) + cells[4]);
      const std::string why = row.was_run() ? remark(row) : "";
      if (!why.empty()) text += wrapped(why, "    ", "    ");
    }
  }
  return text;
}

std::string card_markdown(const StandardCard& card) {
  std::string text = "# " + card.title + "\n\n" + std::string(meaning) + ".\n";
  for (const CardCode& code : card.codes) {
    text += "\n## " + code.name + "\n\n" + score(code) + "." + (code.machine.empty() ? "" : " " + code.machine + ".") +
            "\n\n" + markdown_line(heads()) + markdown_line({"---", "---", "---", "---", "---"});
    for (const CardRow& row : code.rows) {
      std::vector<std::string> cells = cells_of(row);
      const std::string why = row.was_run() ? remark(row) : "";
      if (!why.empty()) cells.back() += ": " + why;
      text += markdown_line(cells);
    }
  }
  return text;
}

std::string card_html(const StandardCard& card) {
  using namespace html;
  std::vector<std::vector<std::string>> rows;
  for (const CardCode& code : card.codes)
    rows.push_back({escaped(code.name), escaped(score(code)), escaped(code.machine.empty() ? "-" : code.machine)});
  std::string body = element("p", escaped(std::string(meaning) + "."));
  if (rows.size() > 1)
    body += section("Codes", "<div class=\"wide\">" + table({"code", "score", "machine"}, rows) + "</div>");
  for (const CardCode& code : card.codes) body += html_of_code(code);
  std::string plots;
  for (std::size_t k = 0; !card.codes.empty() && k < card.codes[0].rows.size(); ++k) plots += html_of_cost(card, k);
  if (!plots.empty()) body += section("What accuracy costs", plots);
  return page(escaped(card.title), body, ".wide { overflow-x: auto }\n");
}

}  // namespace assay::drivers
