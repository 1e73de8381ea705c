// SPDX-License-Identifier: BSD-3-Clause
// Front, digits, errors over time and orders in a study's report.
#include "drivers/output/html.hpp"
#include "drivers/picture/colormap.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/study/study_report_sections.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string cell(const StudyFindings& findings, const Figure& value,
                 std::string (*text)(const StudyFindings&, double)) {
  return value ? unbroken(text(findings, *value)) : html::none;
}

std::string error_of(const StudyFindings& findings, double error) { return error_text(findings, error); }

std::string spread_text(const Figure& spread) { return spread ? "\u00b1 " + plain_text(100 * *spread) + " %" : ""; }

std::string pairs_text(const StudySeries& series) {
  std::string text;
  for (std::size_t k = 1; k < series.pairwise.size(); ++k) {
    text += (k > 1 ? ", " : "") + html::figure(series.pairwise[k], 3);
  }
  return text.empty() ? html::none : text;
}

std::string fit_text(const std::optional<FittedOrder>& fit) {
  if (!fit) return html::none;
  std::string text = element("b", rounded_text(fit->order, 3));
  if (fit->lower && fit->upper) {
    text += " [" + rounded_text(*fit->lower, 3) + ", " + rounded_text(*fit->upper, 3) + "]";
  }
  return text;
}

}  // namespace

std::string pareto(const StudyFindings& findings) {
  if (findings.front.empty()) return {};
  Rows rows;
  std::vector<std::string> heads = front_heads(findings);
  for (std::string& head : heads) head = escaped(head);
  for (const std::size_t index : findings.front) {
    const StudyCase& one = findings.cases[index];
    const std::string spread = spread_text(one.cost_spread);
    rows.push_back({escaped(one.series), unbroken(resolution_text(findings, one)), cell(findings, one.error, error_of),
                    cell(findings, one.cost, cost_text) + (spread.empty() ? "" : element("small", spread))});
    if (rows.back().size() < heads.size()) rows.back().push_back(one.work ? count_text(*one.work) : html::none);
  }
  return html::section("The cases on the front",
                       html::table(heads, rows) +
                           "<p class=\"tally\"><small>No other case is both cheaper and more accurate. Cases that use "
                           "the exact solution do not take part.</small></p>\n" +
                           data_link("pareto.csv"));
}

std::string digits(const StudyFindings& findings) {
  if (findings.digits.empty()) return {};
  Rows rows;
  for (const StudyDigit& digit : findings.digits) {
    const StudyCase* best = digit.best ? &findings.cases[*digit.best] : nullptr;
    rows.push_back(
        {unbroken(error_text(findings, digit.error)),
         best ? escaped(best->series) + element("small", unbroken(resolution_text(findings, *best))) : html::none,
         cell(findings, digit.cost, cost_text), digit.series.empty() ? html::none : escaped(digit.series),
         cell(findings, digit.interpolated, cost_text),
         digit.factor ? element("b", factor_text(*digit.factor)) : html::none});
  }
  return html::section(
      "What the next digit costs",
      html::table({"error", "cheapest measured case", "its cost", "cheapest between resolutions", "cost at this error",
                   "against the digit before"},
                  rows) +
          "<p class=\"tally\"><small>Between two resolutions of a series its cost is interpolated along a straight "
          "line in the logarithms.</small></p>\n" +
          data_link("digits.csv"));
}

std::string histories(const StudyFindings& findings) {
  const std::vector<std::size_t> drawn = drawn_histories(findings);
  if (drawn.empty()) return {};
  LinePlot plot{"", "t [s]", "L_{2} error of the displacement [m]", false, true, {}};
  std::string legend;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const StudyCase& one = findings.cases[drawn[k]];
    Series series;
    for (const auto& [t, error] : one.history) series.x.push_back(t), series.y.push_back(error);
    plot.series.push_back(series);
    legend += "<li><i style=\"background:var(--series-" + std::to_string(k) + "," + css_color(series_color(k)) +
              ")\"></i>" + escaped(one.completed() ? one.label : one.label + ", " + outcome_text(one)) + "</li>\n";
  }
  return html::section("Errors over time", "<ul class=\"legend\">\n" + legend + "</ul>\n<figure>" + svg(plot) +
                                               "</figure>\n" + data_link("histories.csv"));
}

std::string orders(const StudyFindings& findings) {
  Rows rows;
  for (const StudySeries& series : findings.series) {
    if (series.cases.size() < 2) continue;
    const bool reached = series.asymptotic == StudySeries::Range::reached;
    const std::string words = escaped(series.sentence);
    rows.push_back({escaped(series.name), pairs_text(series), fit_text(series.fit),
                    reached ? element("td class=\"words holds\"", words) : words_cell(series.sentence)});
    if (has_published(findings)) rows.back().insert(rows.back().begin() + 3, escaped(published_text(series)));
  }
  if (rows.empty()) return {};
  std::vector<std::string> head{"series", "from grid to grid", "fit, 95 % interval",
                                "<th class=\"left\" scope=\"col\">asymptotic range</th>"};
  if (has_published(findings)) head.insert(head.begin() + 3, "published");
  return html::section("Orders of convergence", html::table(head, rows) + data_link("orders.csv"));
}

}  // namespace assay::drivers::study_page
