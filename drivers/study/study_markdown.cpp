// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_markdown.hpp"

#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/study/survival.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace markdown {

namespace {

using Cells = std::vector<std::string>;

const std::string none = html::none;

/// Text that Markdown takes as it is, on one line.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|").find(c) != std::string_view::npos) out += '\\';
    out += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return out;
}

std::string line_of(const Cells& cells) {
  std::string out = "|";
  for (const std::string& cell : cells) out += " " + cell + " |";
  return out + "\n";
}

/// Empty without rows.
std::string section(const std::string& title, const Cells& head, const std::vector<Cells>& rows) {
  if (rows.empty()) return {};
  std::string out = "\n## " + title + "\n\n" + line_of(head) + line_of(Cells(head.size(), "---"));
  for (const Cells& row : rows) out += line_of(row);
  return out;
}

std::string error_of(const StudyFindings& findings, const Figure& error) {
  return error ? error_text(findings, *error) : none;
}

std::string cost_of(const StudyFindings& findings, const Figure& cost) {
  return cost ? cost_text(findings, *cost) : none;
}

std::string answer(const StudyFindings& findings) {
  std::vector<Cells> rows;
  for (const StudyDigit& digit : findings.digits) {
    const StudyCase* best = digit.best ? &findings.cases[*digit.best] : nullptr;
    rows.push_back({"**" + error_text(findings, digit.error) + "**", best ? plain(best->series) : none,
                    best ? plain(resolution_text(findings, *best)) : none, cost_of(findings, digit.cost),
                    cost_of(findings, digit.interpolated), digit.factor ? factor_text(*digit.factor) : none});
  }
  return section("What the next digit costs",
                 {"error", "cheapest case", "resolution", "its cost", "at this error", "against the digit before"},
                 rows);
}

std::string front(const StudyFindings& findings) {
  std::vector<Cells> rows;
  Cells heads = front_heads(findings);
  for (std::string& head : heads) head = plain(head);
  for (const std::size_t index : findings.front) {
    const StudyCase& one = findings.cases[index];
    rows.push_back({plain(one.series), plain(resolution_text(findings, one)), error_of(findings, one.error),
                    cost_of(findings, one.cost)});
    if (rows.back().size() < heads.size()) rows.back().push_back(one.work ? count_text(*one.work) : none);
  }
  return section("The cases on the front", heads, rows);
}

std::string orders(const StudyFindings& findings) {
  std::vector<Cells> rows;
  for (const StudySeries& series : findings.series) {
    if (series.cases.size() < 2) continue;
    std::string pairs;
    for (std::size_t k = 1; k < series.pairwise.size(); ++k) {
      pairs += (k > 1 ? ", " : "") + html::figure(series.pairwise[k], 3);
    }
    std::string fit = series.fit ? rounded_text(series.fit->order, 3) : none;
    if (series.fit && series.fit->lower && series.fit->upper) {
      fit += " (" + rounded_text(*series.fit->lower, 3) + " to " + rounded_text(*series.fit->upper, 3) + ")";
    }
    rows.push_back({plain(series.name), pairs, fit, plain(series.sentence)});
    if (has_published(findings)) rows.back().insert(rows.back().begin() + 3, plain(published_text(series)));
  }
  Cells head{"series", "from grid to grid", "fit, 95 % interval", "asymptotic range"};
  if (has_published(findings)) head.insert(head.begin() + 3, "published");
  return section("Orders of convergence", head, rows);
}

std::string stability(const StudyFindings& findings) {
  const StabilityMap map = stability_map(findings);
  Cells head{map.row_name.empty() ? none : plain(map.row_name)};
  for (const std::string& column : map.columns) head.push_back(column.empty() ? none : plain(column));
  std::vector<Cells> rows;
  for (const StabilityRow& row : map.rows) {
    rows.push_back({plain(row.name)});
    for (const StabilityCell& cell : row.cells) {
      rows.back().push_back(cell.of.empty() ? none
                                            : plain(cell.text + (cell.detail.empty() ? "" : ", " + cell.detail)));
    }
  }
  return section("What completes and what does not", head, rows);
}

std::string survival(const StudyFindings& findings) {
  std::vector<Cells> rows;
  const std::vector<Survival> methods = survivals(findings);
  for (const Survival& of : methods) {
    rows.push_back({plain(of.method), std::to_string(of.completed) + " of " + std::to_string(of.asked()),
                    std::to_string(of.died), std::to_string(of.refused), std::to_string(of.not_applicable),
                    html::figure(of.error_ratio, 3)});
  }
  const std::string unfinished = unfinished_note(methods);
  return section("Which method completes the most cases",
                 {"method", "completed", "failed", "refused", "n/a", "error over the best"}, rows) +
         "\nError over the best: " + ratio_note + ".\n" + (unfinished.empty() ? "" : "\n" + plain(unfinished) + "\n");
}

std::string budget(const StudyFindings& findings) {
  std::vector<Cells> rows;
  for (const BudgetLine& line : findings.budget) {
    const bool done = line.outcome == "completed";
    rows.push_back({plain(line.base), plain(line.source), plain(line.changed), error_of(findings, line.error),
                    done ? error_of(findings, line.refined) : plain(line.outcome),
                    line.share ? plain_text(100 * *line.share) + " %" : none});
  }
  return section("Where the error comes from", {"case", "source", "refined alone", "error", "refined", "share"}, rows);
}

std::string expectations(const StudyFindings& findings) {
  std::vector<Cells> rows;
  for (const StudyExpectationOutcome& line : findings.expect) {
    rows.push_back({plain(line.where), plain(line.outcome.key), plain(line.outcome.expected),
                    plain(shortened(line.outcome.found, 4)), line.outcome.holds ? "holds" : "**does not hold**"});
  }
  return section("Expectations", {"of", "figure", "expected", "found", "verdict"}, rows);
}

std::string unfinished(const StudyFindings& findings) {
  std::vector<Cells> rows;
  for (const StudyCase& one : findings.cases) {
    if (!one.completed()) rows.push_back({plain(one.label), plain(outcome_text(one)), plain(one.reason)});
  }
  return section("Cases that did not complete", {"case", "outcome", "reason"}, rows);
}

std::string ending(const StudyFindings& findings) {
  std::string out;
  if (!findings.warnings.empty()) out += "\n## Warnings\n\n";
  for (const std::string& warning : findings.warnings) out += "- " + plain(warning) + "\n";
  const Provenance& from = findings.provenance;
  out +=
      "\nassay " + plain(from.version) + ", " + plain(from.git) + ", " + plain(from.compiler) + " " + plain(from.flags);
  for (const std::string& machine : findings.machines) out += "; " + plain(machine);
  return out + "\n";
}

}  // namespace

}  // namespace markdown

std::string study_markdown(const StudyFindings& findings) {
  using namespace markdown;
  std::string out = "# " + plain(findings.title.empty() ? "assay study" : findings.title) + "\n";
  if (!findings.question.empty()) out += "\n" + plain(findings.question) + "\n";
  out += "\nError: " + plain(findings.error_name) + ". Cost: " + plain(findings.cost_name) + ".\n";
  out += findings.asks_survival ? survival(findings) : answer(findings) + front(findings) + orders(findings);
  return out + stability(findings) + budget(findings) + expectations(findings) + unfinished(findings) +
         ending(findings);
}

}  // namespace assay::drivers
