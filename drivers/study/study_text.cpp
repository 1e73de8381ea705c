// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/study/study_words.hpp"
#include "drivers/study/survival.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/table_text.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t number_width = 10;

/// What begins a line, a blank at its end whatever its length.
std::string column(const std::string& text, std::size_t width) { return padded(text + " ", width); }

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The text with a blank after every `most` characters of a word.
std::string with_short_words(const std::string& text, std::size_t most) {
  std::string split;
  std::size_t length = 0;
  for (const char c : text) {
    if (c == ' ') length = 0;
    const bool begins = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // a character of UTF-8
    if (c != ' ' && begins && ++length > most) split += ' ', length = 1;
    split += c;
  }
  return split;
}

/// The line; an end that is too long goes on below its own beginning.
std::string line_of(const std::string& begin, const std::string& end) {
  constexpr std::size_t columns = 80, least = 20;  // of an end
  const std::size_t room = columns - std::min(columns - least, characters(begin));
  if (characters(begin) + characters(end) <= columns) return begin + end + "\n";
  const std::string below(columns - room, ' ');  // of as many characters as `begin`, which may have more bytes
  return begin + wrapped(with_short_words(end, room), below, below).substr(below.size());
}

std::string or_dash(const Figure& value, const StudyFindings& findings,
                    std::string (*text)(const StudyFindings&, double)) {
  return value ? text(findings, *value) : "-";
}

std::string error_words(const StudyFindings& findings, double error) { return error_text(findings, error); }

std::string row(const std::string& a, const std::string& b, const std::string& c, const std::string& rest) {
  return line_of("  " + column(a, number_width) + column(b, number_width) + column(c, number_width), rest);
}

std::string digits_text(const StudyFindings& findings) {
  if (findings.digits.empty() && findings.front.empty())
    return wrapped("no case has both an error and a cost" + rest_words(findings), "", "  ");
  if (findings.digits.empty()) return "the error is 0, so there is no next digit\n";
  std::string text = row("error", "costs", "one more", "the cheapest case that was measured");
  for (const StudyDigit& digit : findings.digits) {
    const std::string level = "<= " + error_text(findings, digit.error);
    if (!digit.best) {
      text += row(level, "-", "", "no case of this study");
      continue;
    }
    text += row(level, or_dash(digit.interpolated, findings, cost_text), digit.factor ? factor_text(*digit.factor) : "",
                or_dash(digit.cost, findings, cost_text) + ": " + findings.cases[*digit.best].label);
  }
  return text;
}

std::string front_text(const StudyFindings& findings) {
  std::string text = "cases that no other case beats in both error and cost:\n";
  for (const std::size_t i : findings.front) {
    const StudyCase& one = findings.cases[i];
    const std::string spread = one.cost_spread ? "+-" + rounded_text(100 * *one.cost_spread, 2) + " %" : "";
    text += row(error_text(findings, *one.error), cost_text(findings, *one.cost), spread, one.label);
  }
  return text;
}

std::string order_text(const StudySeries& series) {
  if (!series.fit) return "-";
  std::string text = rounded_text(series.fit->order, 3);
  if (series.fit->lower && series.fit->upper) {
    text += " [" + rounded_text(*series.fit->lower, 2) + ", " + rounded_text(*series.fit->upper, 2) + "]";
  }
  return text;
}

std::string orders_text(const StudyFindings& findings) {
  std::string text = "orders, with 95 % intervals:\n";
  for (const StudySeries& series : findings.series) {
    constexpr const char* words[] = {"asymptotic", "not asymptotic", "unknown range"};
    const std::string range = words[static_cast<std::size_t>(series.asymptotic)];
    text += line_of("  " + column(order_text(series), 20) + column(range, 16), series.name);
    if (series.published) text += wrapped("published: " + published_text(series), "    ", "    ");
  }
  return text;
}

std::string deaths_text(const StudyFindings& findings) {
  std::string text;
  for (const StudyCase& one : findings.cases) {
    if (!one.completed())
      text += wrapped(one.outcome + ": " + one.label + (one.reason.empty() ? "" : ": " + one.reason), "  ", "    ");
  }
  return text;
}

std::string budget_text(const StudyFindings& findings) {
  std::string text = "share of each source of error, found by refining it alone:\n";
  for (const BudgetLine& line : findings.budget) {
    const std::string share = line.share ? rounded_text(100 * *line.share, 2) + " %" : line.outcome;
    text += row(share, or_dash(line.error, findings, error_words), or_dash(line.refined, findings, error_words),
                line.source + " (" + line.changed + "), " + line.base);
  }
  return text;
}

std::string failures_text(const StudyFindings& findings) {
  std::string text;
  for (const auto& [where, outcome] : findings.expect) {
    if (outcome.holds) continue;
    text += wrapped(
        fmt::format("FAILS {} {}: found {}; {}", outcome.key, outcome.expected, shortened(outcome.found, 4), where),
        "  ", "    ");
  }
  return text;
}

std::string held_text(const StudyFindings& findings) {
  if (findings.expect.empty()) return "";
  const auto held = std::count_if(findings.expect.begin(), findings.expect.end(),
                                  [](const auto& each) { return each.outcome.holds; });
  return fmt::format("  {} of {} expectations hold\n", held, findings.expect.size());
}

std::string summary_of(const StudyFindings& findings) {
  return !findings.holds() ? "NOT AS EXPECTED" : findings.expect.empty() ? "NOTHING WAS EXPECTED" : "AS EXPECTED";
}

std::string counts_text(const StudyFindings& findings) {
  std::string text;
  for (const char* outcome :
       {"completed", "unstable", "material_failed", "refused", "n/a", "crashed", "stopped", "missing"}) {
    const int count = findings.count(outcome);
    if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + outcome;
  }
  return text;
}

}  // namespace

std::string case_line(const StudyFindings& words, const StudyCase& one, std::size_t done, std::size_t total) {
  const std::string count = std::to_string(total);
  const std::string begin = fmt::format("{:>{}}/{}  {}{}{}", done, count.size(), count, column(one.outcome, 11),
                                        column(one.error ? error_text(words, *one.error) : "", number_width),
                                        column(one.cost ? cost_text(words, *one.cost) : "", number_width));
  return line_of(begin, one.label);
}

std::string contradiction_text(const StudyFindings& findings) {
  const std::string counts = counts_text(findings);
  const std::string verdict = (findings.title.empty() ? "study" : findings.title) + ": " +
                              (counts.empty() ? "" : counts + ": ") + summary_of(findings);
  return wrapped(verdict, "", "  ") + failures_text(findings);
}

std::string study_text(const StudyFindings& findings, const std::string& folder) {
  std::string text = contradiction_text(findings);
  if (!findings.question.empty()) text += wrapped(findings.question, "  ", "  ");
  text += wrapped("error: " + findings.error_name + "; cost: " + findings.cost_name, "  ", "    ");
  if (findings.asks_survival) {
    text += survival_table(survivals(findings));
  } else {
    text += digits_text(findings);
    if (!findings.front.empty()) text += front_text(findings);
  }
  const auto has_fit = [](const StudySeries& series) { return series.fit.has_value(); };
  if (std::any_of(findings.series.begin(), findings.series.end(), has_fit)) text += orders_text(findings);
  if (!findings.budget.empty()) text += budget_text(findings);
  const std::string deaths = deaths_text(findings);
  if (!deaths.empty()) text += "not completed:\n" + deaths;
  for (const std::string& warning : findings.warnings) text += wrapped("warning: " + warning, "  ", "    ");
  text += held_text(findings);
  return text +
         wrapped(fmt::format("{}; results in {}, begin with its report.html", summary_of(findings), one_line(folder)),
                 "", "  ");
}

}  // namespace assay::drivers
