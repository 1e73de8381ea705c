// SPDX-License-Identifier: BSD-3-Clause
// Stability, budget, profile, expectations, and where a study comes from, in its report.
#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/output/report.hpp"
#include "drivers/study/clock.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_report_sections.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string error_cell(const StudyFindings& findings, const Figure& error) {
  return error ? unbroken(error_text(findings, *error)) : html::none;
}

double most(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

std::string stability(const StudyFindings& findings) {
  if (findings.cases.empty()) return {};
  return html::section("What completes and what does not",
                       stability_table(stability_map(findings)) +
                           "<p class=\"tally\"><small>Blue: completed; darker means a smaller error. Orange: failed at "
                           "that time. Grey: refused or stopped.</small></p>\n" +
                           data_link("stability.csv"));
}

std::string budget(const StudyFindings& findings) {
  if (findings.budget.empty()) return {};
  double largest = 0;
  for (const BudgetLine& line : findings.budget) largest = std::max(largest, line.share.value_or(0));
  Rows rows;
  for (const BudgetLine& line : findings.budget) {
    const double width = line.share && largest > 0 ? 100 * *line.share / largest : 0;
    const bool done = line.outcome == "completed";
    rows.push_back({escaped(line.source) + element("small", escaped(line.base)), element("code", escaped(line.changed)),
                    error_cell(findings, line.error),
                    done ? error_cell(findings, line.refined) : element("td class=\"fails\"", escaped(line.outcome)),
                    line.share ? unbroken(plain_text(100 * *line.share) + " %") : html::none,
                    width > 0 ? "<td class=\"bar\"><i style=\"width:" + rounded_text(width, 4) + "%\"></i></td>"
                              : "<td class=\"bar\"></td>"});
  }
  return html::section("Where the error comes from",
                       html::table({"source", "refined alone", "error", "refined", "share", ""}, rows) +
                           "<p class=\"tally\"><small>Share: the largest change of the error over time if this source "
                           "alone is refined, divided by the largest error of the run.</small></p>\n" +
                           data_link("budget.csv"));
}

std::string profile(const StudyFindings& findings) {
  const StudyCase* best = nullptr;
  for (const std::size_t index : findings.front) {
    if (!findings.cases[index].passes.empty()) best = &findings.cases[index];
  }
  if (!best) return {};
  return html::section("Where its time went", element("p class=\"tally\"", "For the most accurate case on the front: " +
                                                                               escaped(best->label)) +
                                                  "\n" + profile_table(best->passes) + data_link("passes.csv"));
}

std::string expectations(const StudyFindings& findings) {
  if (findings.expect.empty()) return {};
  Rows rows;
  for (const StudyExpectationOutcome& line : findings.expect) {
    rows.push_back({escaped(line.where), escaped(line.outcome.key), escaped(line.outcome.expected),
                    escaped(shortened(line.outcome.found, 4)),
                    line.outcome.holds ? "<td class=\"holds\">holds</td>" : "<td class=\"fails\">does not hold</td>"});
  }
  return html::section("Expectations", html::table({"of", "figure", "expected", "found", "verdict"}, rows));
}

std::string unfinished(const StudyFindings& findings) {
  Rows rows;
  for (const StudyCase& one : findings.cases) {
    if (!one.completed()) rows.push_back({escaped(one.label), escaped(outcome_text(one)), words_cell(one.reason)});
  }
  if (rows.empty()) return {};
  return html::section(
      "Cases that did not complete",
      html::table({"case", "outcome", "<th class=\"left\" scope=\"col\">reason</th>"}, rows) + data_link("cases.csv"));
}

std::string warnings(const StudyFindings& findings) {
  std::string out;
  for (const std::string& warning : findings.warnings) out += element("li", escaped(warning)) + "\n";
  return out.empty() ? out : html::section("Warnings", "<ul>\n" + out + "</ul>\n");
}

std::string clock(const StudyFindings& findings) {
  Rows rows;
  for (const StudyCase& one : findings.cases) {
    const ClockReadings& clock = one.clock;
    const std::size_t repeats = std::max(clock.step_s.size(), clock.cpu_s.size());
    const double others = most(clock.others);
    if (repeats == 0 || (!one.on_front && !is_disturbed(clock))) continue;
    std::string remark = clock.alone ? "" : "beside other cases";
    if (is_disturbed(clock))
      remark += (remark.empty() ? "" : "; ") + std::string("the machine was busy with other things");
    const Figure memory = number_of(one, "peak_rss_bytes");
    rows.push_back(
        {escaped(one.label), std::to_string(repeats), one.cost ? escaped(cost_text(findings, *one.cost)) : html::none,
         one.cost_spread ? "\u00b1 " + plain_text(100 * *one.cost_spread) + " %" : html::none, plain_text(others),
         memory ? plain_text(*memory / (1024.0 * 1024.0), 3) + " MiB" : html::none, words_cell(remark)});
  }
  if (rows.empty()) return {};
  return html::section(
      "The clock",
      html::table({"case", "repeats", "median", "spread", "others [cores]", "memory", ""}, rows) +
          "<p class=\"tally\"><small>Cases on the front, and cases during which other programs kept more than " +
          disturbing_text() + " busy.</small></p>\n" + data_link("timing.csv"));
}

std::string provenance(const StudyFindings& findings) {
  const Provenance& from = findings.provenance;
  std::string out = "<dl class=\"facts\">\n" + html::fact("assay", escaped(from.version)) +
                    html::fact("Commit", escaped(from.git)) + html::fact("Compiler", escaped(from.compiler)) +
                    html::fact("Flags", escaped(from.flags)) + html::fact("Libraries", escaped(joined(from.libraries)));
  if (!from.material.empty()) out += html::fact("Material", escaped(from.material));
  out += html::fact("Machines", escaped(joined(findings.machines)));
  out += html::fact("Error", escaped(findings.error_name) + ", <code>" + escaped(findings.error_key) + "</code>");
  out += html::fact("Cost", escaped(findings.cost_name) + ", <code>" + escaped(findings.cost_key) + "</code>");
  return html::section("Origin of the results", out + "</dl>\n" + data_link("cases.csv"));
}

}  // namespace assay::drivers::study_page
