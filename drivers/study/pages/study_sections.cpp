// SPDX-License-Identifier: BSD-3-Clause
// The parts of a study that several pages have.
#include "drivers/study/pages/study_sections.hpp"

#include <algorithm>

#include "drivers/format/csv.hpp"
#include "drivers/output/html.hpp"
#include "drivers/study/analysis/recommendation.hpp"
#include "drivers/study/pages/study_figures.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

/// Columns of Markdown and HTML alone.
std::vector<Column> columns_of(const std::vector<std::string>& heads) {
  return mapped(heads, [](const std::string& head) { return Column{"", "", head, head}; });
}

/// A head of a table in HTML that may be empty.
std::string html_head(const std::string& name) { return element("th scope=\"col\"", escaped(name)); }

Cell error_cell(const StudyFindings& findings, const Figure& error) {
  return unbroken_cell(error, error ? error_text(findings, *error) : "");
}

Cell cost_cell(const StudyFindings& findings, const Figure& cost) {
  return unbroken_cell(cost, cost ? cost_text(findings, *cost) : "");
}

std::string pairs_text(const StudySeries& series) {
  std::string text;
  for (std::size_t k = 1; k < series.pairwise.size(); ++k)
    text += (k > 1 ? ", " : "") + html::figure(series.pairwise[k], 3);
  return text;
}

Cell fit_cell(const std::optional<FittedOrder>& fit) {
  if (!fit) return html::none;
  const std::string order = rounded_text(fit->order, 3);
  if (!fit->lower || !fit->upper) return Cell(order).on(Page::html, element("b", order));
  const std::string lower = rounded_text(*fit->lower, 3), upper = rounded_text(*fit->upper, 3);
  return Cell(order + " (" + lower + " to " + upper + ")")
      .on(Page::html, element("b", order) + " [" + lower + ", " + upper + "]");
}

/// Why there is no table of digits.
std::string no_digits_text(const StudyFindings& findings) {
  if (!findings.front.empty()) return "the error is 0, so there is no next digit\n";
  return wrapped("no case has both an error and a cost" + rest_words(findings), "", "  ");
}

/// A bar of the share of the largest one.
std::string bar(double share) {
  return "<td class=\"bar\">" +
         (share > 0 ? "<i style=\"width:" + rounded_text(share, 4) + "%\"></i>" : std::string()) + "</td>";
}

}  // namespace

Section digits(const StudyFindings& findings) {
  Section out{"What the next digit costs", "digits.csv",
              "Between two resolutions of a series its cost is interpolated along a straight line in the logarithms."};
  if (findings.digits.empty()) out.before[Page::terminal] = no_digits_text(findings);
  out.table.columns = {{"error", "error", "error", "error"},
                       {"case", "", "", ""},
                       {"", "", "cheapest case", "cheapest measured case"},
                       {"", "", "resolution", ""},
                       {"cost", "", "its cost", "its cost"},
                       {"series", "", "", "cheapest between resolutions"},
                       {"interpolated_cost", "costs", "at this error", "cost at this error"},
                       {"factor", "one more", "against the digit before", "against the digit before"},
                       {"", "the cheapest case that was measured", "", ""}};
  for (const StudyDigit& digit : findings.digits) {
    const StudyCase* best = digit.best ? &findings.cases[*digit.best] : nullptr;
    const std::string level = error_text(findings, digit.error), none = html::none,
                      resolution = best ? resolution_text(findings, *best) : none;
    const Cell cost = cost_cell(findings, digit.cost), between = cost_cell(findings, digit.interpolated);
    const std::string factor = digit.factor ? factor_text(*digit.factor) : none;
    out.table.rows.push_back(
        {error_cell(findings, digit.error).on(Page::terminal, "<= " + level).on(Page::markdown, "**" + level + "**"),
         best ? best->label : "",
         best ? Cell(best->series).on(Page::html, escaped(best->series) + element("small", unbroken(resolution)))
              : Cell(none),
         resolution, cost, Cell(digit.series).on(Page::html, digit.series.empty() ? none : escaped(digit.series)),
         best ? between : Cell(between).on(Page::terminal, "-"),
         figure_cell(digit.factor, factor)
             .on(Page::terminal, best && digit.factor ? factor : "")
             .on(Page::html, digit.factor ? element("b", factor) : none),
         best ? (digit.cost ? cost.text : "-") + ": " + best->label : "no case of this study"});
  }
  return out;
}

Section front(const StudyFindings& findings) {
  Section out{"The cases on the front", "pareto.csv",
              "No other case is both cheaper and more accurate. Cases that use the exact solution do not take part."};
  if (!findings.front.empty()) out.before[Page::terminal] = "cases that no other case beats in both error and cost:\n";
  const std::string work = findings.cost_key == work_key ? "" : "particle-steps";  // they stand there once
  out.table.columns = {{"number", "", "", ""},
                       {"case", "", "", ""},
                       {"series", "", "case", "case"},
                       {"resolution", "", "resolution", "resolution"},
                       {"error", "error", "error", "error"},
                       {"cost", "cost", plain_markdown(findings.cost_name), escaped(findings.cost_name)},
                       {"cost_spread", "spread", "", ""},
                       {"particle_steps", "", work, work},
                       {"", "case", "", ""}};
  for (const std::size_t index : findings.front) {
    const StudyCase& one = findings.cases[index];
    const Cell cost = cost_cell(findings, one.cost);
    const std::string resolution = resolution_text(findings, one);
    out.table.rows.push_back(
        {std::to_string(one.number), one.label, one.series,
         Cell(resolution).on(Page::csv, csv_number(one.resolution)).on(Page::html, unbroken(resolution)),
         error_cell(findings, one.error),
         Cell(cost).on(Page::html, cost.instead.at(Page::html) +
                                       (one.cost_spread ? element("small", spread_text(*one.cost_spread)) : "")),
         figure_cell(one.cost_spread, "")
             .on(Page::terminal, one.cost_spread ? "+-" + rounded_text(100 * *one.cost_spread, 2) + " %" : ""),
         figure_cell(one.work, one.work ? count_text(*one.work) : ""), one.label});
  }
  return out;
}

Section orders(const StudyFindings& findings) {
  Section out{"Orders of convergence", "orders.csv"};
  out.before[Page::terminal] = orders_text(findings);
  const bool any =
      std::ranges::any_of(findings.series, [](const auto& series) { return series.published.has_value(); });
  const std::string published = any ? "published" : "";
  out.table.columns = {{"", "", "series", "series"},
                       {"", "", "from grid to grid", "from grid to grid"},
                       {"", "", "fit, 95 % interval", "fit, 95 % interval"},
                       {"", "", published, published},
                       {"", "", "asymptotic range", "<th class=\"left\" scope=\"col\">asymptotic range</th>"}};
  for (const StudySeries& series : findings.series) {
    if (series.cases.size() < 2) continue;
    const bool reached = series.asymptotic == StudySeries::Range::reached;
    const std::string pairs = pairs_text(series);
    out.table.rows.push_back({series.name, Cell(pairs).on(Page::html, pairs.empty() ? html::none : pairs),
                              fit_cell(series.fit), published_text(series),
                              words_cell(series.sentence, reached ? "words holds" : "words")});
  }
  return out;
}

Section stability(const StudyFindings& findings) {
  Section out{"What completes and what does not", "stability.csv",
              "Blue: completed; darker means a smaller error. Orange: failed at that time. Grey: refused or stopped."};
  const StabilityMap map = stability_map(findings);
  const auto add_column = [&](const std::string& name, const std::string& head) {
    out.table.columns.push_back({"", "", name.empty() ? html::none : plain_markdown(name), html_head(head)});
  };
  add_column(map.row_name, map.row_name);
  for (const std::string& column : map.columns)
    add_column(column, map.column_name.empty() ? column : map.column_name + " = " + column);
  for (const StabilityRow& row : map.rows) {
    auto& cells = out.table.rows.emplace_back(std::vector<Cell>{row.name});
    for (const StabilityCell& cell : row.cells) {
      const std::string words = cell.text + (cell.detail.empty() ? "" : ", " + cell.detail);
      cells.push_back(Cell(cell.of.empty() ? html::none : words).on(Page::html, stability_cell(cell)));
    }
  }
  return out;
}

Section survival(const StudyFindings& findings) {
  Section out{"Which method completes the most cases"};
  const std::vector<Survival> methods = survivals(findings);
  const std::string unfinished = unfinished_note(methods), note = std::string("Error over the best: ") + ratio_note;
  out.before[Page::terminal] = survival_table(methods);
  out.after[Page::markdown] =
      "\n" + note + ".\n" + (unfinished.empty() ? "" : "\n" + plain_markdown(unfinished) + "\n");
  out.after[Page::html] = element("p class=\"tally\"", escaped(note + ". " + unfinished));
  out.table.columns = columns_of({"method", "completed", "failed", "refused", "n/a", "error over the best"});
  for (const Survival& of : methods) {
    out.table.rows.push_back({of.method, of.completed_text(), std::to_string(of.died), std::to_string(of.refused),
                              std::to_string(of.not_applicable), html::figure(of.error_ratio, 3)});
  }
  return out;
}

Section budget(const StudyFindings& findings) {
  Section out{"Where the error comes from", "budget.csv",
              "Share: the largest change of the error over time if this source alone is refined, "
              "divided by the largest error of the run."};
  if (!findings.budget.empty())
    out.before[Page::terminal] = "share of each source of error, found by refining it alone:\n";
  out.table.columns = {{"", "share", "", ""},
                       {"case", "", "case", ""},
                       {"source", "", "source", "source"},
                       {"changed", "", "refined alone", "refined alone"},
                       {"error", "error", "error", "error"},
                       {"refined", "refined", "refined", "refined"},
                       {"share", "", "share", "share"},
                       {"outcome", "", "", ""},
                       {"", "source, case", "", ""},
                       {"", "", "", html_head("")}};
  double largest = 0;
  for (const BudgetLine& line : findings.budget) largest = std::max(largest, line.share.value_or(0));
  for (const BudgetLine& line : findings.budget) {
    Cell refined = error_cell(findings, line.refined);
    if (line.outcome != "completed") {
      refined.instead[Page::markdown] = plain_markdown(line.outcome);
      refined.instead[Page::html] = element("td class=\"fails\"", escaped(line.outcome));
    }
    out.table.rows.push_back(
        {line.share ? rounded_text(100 * *line.share, 2) + " %" : line.outcome, line.base,
         Cell(line.source).on(Page::html, escaped(line.source) + element("small", escaped(line.base))),
         Cell(line.changed).on(Page::html, element("code", escaped(line.changed))), error_cell(findings, line.error),
         refined, unbroken_cell(line.share, line.share ? plain_text(100 * *line.share) + " %" : ""), line.outcome,
         line.source + " (" + line.changed + "), " + line.base,
         Cell("").on(Page::html, bar(line.share && largest > 0 ? 100 * *line.share / largest : 0))});
  }
  return out;
}

Section expectations(const StudyFindings& findings) {
  Section out{"Expectations"};
  out.table.columns = columns_of({"of", "figure", "expected", "found", "verdict"});
  for (const auto& [where, outcome] : findings.expect) {
    const Cell verdict = outcome.holds ? words_cell("holds", "holds")
                                       : words_cell("does not hold", "fails").on(Page::markdown, "**does not hold**");
    out.table.rows.push_back({where, outcome.key, outcome.expected, shortened(outcome.found, 4), verdict});
  }
  return out;
}

Section unfinished(const StudyFindings& findings) {
  Section out{"Cases that did not complete", "cases.csv"};
  out.table.columns = {{"", "", "case", "case"},
                       {"", "", "outcome", "outcome"},
                       {"", "", "reason", "<th class=\"left\" scope=\"col\">reason</th>"}};
  std::string lines;
  for (const StudyCase& one : findings.cases) {
    if (one.completed()) continue;
    out.table.rows.push_back({one.label, outcome_text(one), words_cell(one.reason)});
    lines += wrapped(one.outcome + ": " + one.label + (one.reason.empty() ? "" : ": " + one.reason), "  ", "    ");
  }
  if (!lines.empty()) out.before[Page::terminal] = "not completed:\n" + lines;
  return out;
}

Section warnings(const StudyFindings& findings) {
  Section out{"Warnings"};
  for (const std::string& warning : findings.warnings) {
    out.before[Page::terminal] += wrapped("warning: " + warning, "  ", "    ");
    out.before[Page::markdown] += "- " + plain_markdown(warning) + "\n";
    out.before[Page::html] += element("li", escaped(warning)) + "\n";
  }
  if (!findings.warnings.empty()) out.before[Page::html] = "<ul>\n" + out.before[Page::html] + "</ul>\n";
  return out;
}

/// What is asked, and how it is measured.
Section question(const StudyFindings& findings) {
  Section out;
  const std::string& text = findings.question;
  out.before[Page::terminal] = (text.empty() ? "" : wrapped(text, "  ", "  ")) +
                               wrapped("error: " + findings.error_name + "; cost: " + findings.cost_name, "  ", "    ");
  out.before[Page::markdown] = (text.empty() ? "" : "\n" + plain_markdown(text) + "\n") +
                               "\nError: " + plain_markdown(findings.error_name) +
                               ". Cost: " + plain_markdown(findings.cost_name) + ".\n";
  if (!text.empty()) out.before[Page::html] = element("p class=\"question\"", escaped(text)) + "\n";
  return out;
}

/// Which program and machines.
Section origin(const StudyFindings& findings) {
  const Provenance& from = findings.provenance;
  std::string line = "assay " + plain_markdown(from.version) + ", " + plain_markdown(from.git) + ", " +
                     plain_markdown(from.compiler) + " " + plain_markdown(from.flags);
  for (const std::string& machine : findings.machines) line += "; " + plain_markdown(machine);
  Section out;
  out.before[Page::markdown] = "\n" + line + "\n";
  return out;
}

}  // namespace assay::drivers::study_page
