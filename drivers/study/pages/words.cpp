// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/words.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "drivers/study/pages/document.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

std::string order_text(const StudySeries& series) {
  if (!series.fit) return "-";
  std::string text = rounded_text(series.fit->order, 3);
  if (!series.fit->lower || !series.fit->upper) return text;
  return text + " [" + rounded_text(*series.fit->lower, 2) + ", " + rounded_text(*series.fit->upper, 2) + "]";
}

std::string summary_of(const StudyFindings& findings) {
  return !findings.holds() ? "NOT AS EXPECTED" : findings.expect.empty() ? "NOTHING WAS EXPECTED" : "AS EXPECTED";
}

}  // namespace

std::string plain_text(double value, int significant) {
  std::string rounded = rounded_text(value, significant);
  const double size = std::abs(value);
  if (!(size >= 1e-5 && size < 1e6)) return rounded;
  return rounded_text(parse_number(rounded).value_or(value), 9);
}

std::string error_text(const StudyFindings& findings, double error, bool bare) {
  if (!findings.error_unit.empty()) return plain_text(error) + (bare ? "" : " " + findings.error_unit);
  return plain_text(100 * error) + (bare ? "" : " %");
}

bool is_time(const StudyFindings& findings) { return findings.cost_unit == "s"; }

std::string cost_text(const StudyFindings& findings, double cost) {
  if (!is_time(findings)) return count_text(cost) + (findings.cost_unit.empty() ? "" : " " + findings.cost_unit);
  if (cost < 120) return plain_text(cost) + " s";
  return cost < 7200 ? plain_text(cost / 60) + " min" : plain_text(cost / 3600) + " h";
}

std::string count_text(double value) {
  if (value >= 1e9) return plain_text(value / 1e9) + " billion";
  if (value >= 1e6) return plain_text(value / 1e6) + " million";
  if (value >= 1e3) return grouped_text(std::llround(parse_number(rounded_text(value, 2)).value_or(value)));
  return plain_text(value);
}

std::string resolution_text(const StudyFindings& findings, const StudyCase& one) {
  const std::string& key = findings.refine_key;
  if (key.empty()) return {};
  const std::string name = key == "grid.spacing" ? "h" : key.substr(key.rfind('.') + 1);
  const std::string value = value_on(one, key);
  if (!value.empty()) return name + " = " + value;
  return one.resolution ? name + " = " + plain_text(*one.resolution, 4) : "";
}

std::string factor_text(double factor) { return "\u00d7" + plain_text(factor); }

std::string outcome_text(const StudyCase& one) {
  std::string text = in_plain_words(one.outcome);
  const Figure t = number_of(one, "t");
  const bool ran = one.outcome != "completed" && one.outcome != "n/a" && one.outcome != "refused";
  return ran && t ? text + " at t = " + plain_text(*t) + " s" : text;
}

std::vector<std::size_t> drawn_histories(const StudyFindings& findings) {
  std::vector<std::size_t> drawn;
  for (const std::size_t i : findings.work_front) {
    if (!findings.cases[i].history.empty()) drawn.push_back(i);
  }
  constexpr std::size_t most = 7;
  if (drawn.size() > most) drawn.erase(drawn.begin(), drawn.end() - most);  // the most accurate stay
  std::size_t levels = 0;
  for (const StudySeries& series : findings.series) levels = std::max(levels, series.cases.size());
  for (std::size_t back = 1; back <= levels; ++back) {
    for (const StudySeries& series : findings.series) {
      if (drawn.size() == most || back > series.cases.size()) continue;
      const std::size_t i = series.cases[series.cases.size() - back];
      const bool known = std::ranges::find(drawn, i) != drawn.end();
      if (!known && !findings.cases[i].history.empty()) drawn.push_back(i);
    }
  }
  return drawn;
}

std::string published_text(const StudySeries& series) {
  return series.published ? rounded_text(*series.published, 3) + " (" + series.source + ")" : "";
}

std::string spread_text(double spread) { return "\u00b1 " + plain_text(100 * spread) + " %"; }

std::string counts_text(const StudyFindings& findings, const std::vector<std::string>& outcomes) {
  std::string text;
  for (const std::string& outcome : outcomes) {
    const int count = findings.count(outcome);
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + outcome;
  }
  return text;
}

std::string case_line(const StudyFindings& words, const StudyCase& one, std::size_t done, std::size_t total) {
  const std::string count = std::to_string(total);
  const std::string begin =
      fmt::format("{:>{}}/{}  {}{}{}", done, count.size(), count, study_page::terminal_column(one.outcome, 11),
                  study_page::terminal_column(one.error ? error_text(words, *one.error) : "", 10),
                  study_page::terminal_column(one.cost ? cost_text(words, *one.cost) : "", 10));
  return study_page::terminal_line(begin, one.label);
}

std::string contradiction_text(const StudyFindings& findings) {
  const std::string counts = counts_text(
      findings, {"completed", "unstable", "material_failed", "refused", "n/a", "crashed", "stopped", "missing"});
  std::string text = wrapped((findings.title.empty() ? "study" : findings.title) + ": " +
                                 (counts.empty() ? "" : counts + ": ") + summary_of(findings),
                             "", "  ");
  for (const auto& [where, outcome] : findings.expect) {
    if (outcome.holds) continue;
    text += wrapped(
        fmt::format("FAILS {} {}: found {}; {}", outcome.key, outcome.expected, shortened(outcome.found, 4), where),
        "  ", "    ");
  }
  return text;
}

std::string orders_text(const StudyFindings& findings) {
  if (std::ranges::none_of(findings.series, [](const auto& series) { return series.fit.has_value(); })) return {};
  std::string text = "orders, with 95 % intervals:\n";
  for (const StudySeries& series : findings.series) {
    constexpr const char* words[] = {"asymptotic", "not asymptotic", "unknown range"};
    const std::string range = words[static_cast<std::size_t>(series.asymptotic)];
    text += study_page::terminal_line(
        "  " + study_page::terminal_column(order_text(series), 20) + study_page::terminal_column(range, 16),
        series.name);
    if (series.published) text += wrapped("published: " + published_text(series), "    ", "    ");
  }
  return text;
}

std::string ending_text(const StudyFindings& findings, const std::string& folder) {
  const auto held = std::ranges::count_if(findings.expect, [](const auto& each) { return each.outcome.holds; });
  return (findings.expect.empty() ? "" : fmt::format("  {} of {} expectations hold\n", held, findings.expect.size())) +
         wrapped(fmt::format("{}; results in {}, begin with its report.html", summary_of(findings), one_line(folder)),
                 "", "  ");
}

std::string survival_table(const std::vector<Survival>& found) {
  constexpr std::size_t widest = 34;
  std::string text = padded("method", widest) + "  completed failed  refused    n/a  error/best\n";
  for (const Survival& of : found) {
    text += table_line(fmt::format("{}{:>11}{:>7}{:>9}{:>7}{:>12}", padded(one_line(of.method, widest), widest),
                                   of.completed_text(), of.died, of.refused, of.not_applicable,
                                   measured_text(of.error_ratio)));
  }
  return text;
}

std::string unfinished_note(const std::vector<Survival>& found) {
  std::string text;
  for (const Survival& of : found) {
    if (of.unfinished > 0)
      text += (text.empty() ? "" : "; ") + one_line(of.method, 80) + " " + std::to_string(of.unfinished);
  }
  return text.empty() ? text : "Stopped, or not run yet: " + text + ".";
}

}  // namespace assay::drivers
