// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/comparison_text.hpp"

#include <algorithm>
#include <sstream>

#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/table_text.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t label_width = 32, words_width = 17, ratio_width = 10;

/// Lines of at most the label's column, less a blank.
std::vector<std::string> label_lines(const std::string& label) {
  std::istringstream text(wrapped(label, "", "  ", label_width - 1));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);)
    lines.push_back(line.size() < label_width ? line : one_line(line, label_width - 4));
  return lines;
}

std::string rows_of(const ComparedCase& one) {
  const std::vector<std::string> label = label_lines(one.label), words = words_of(one);
  std::string rows;
  for (std::size_t i = 0; i < std::max(label.size(), words.size()); ++i) {
    std::string row = padded(i < label.size() ? label[i] : "", label_width);
    row += padded(i < words.size() ? words[i] : "", words_width);
    if (i == 0) row += padded(ratio_text(one.error), ratio_width) + padded(ratio_text(one.cost), ratio_width);
    if (i == 0) row += noise_text(one);
    rows += table_line(row);
  }
  return rows;
}

std::string table_of(const Comparison& found, bool all) {
  std::string rows;
  for (const ComparedCase& one : found.cases) {
    if (all || !one.is_same()) rows += rows_of(one);
  }
  if (rows.empty()) return {};
  return "\n" +
         table_line(padded("case", label_width) + padded("B against A", words_width) +
                    padded("error B/A", ratio_width) + padded("cost B/A", ratio_width) + "noise") +
         rows;
}

std::string digit_lines(const StudyFindings& findings, const Comparison& found) {
  if (found.digits.empty()) return {};
  const auto name = [](const std::string& label) { return label.empty() ? std::string("none") : label; };
  std::string text = "\nthe cheapest case at an error of\n";
  for (const ComparedDigit& digit : found.digits) {
    const std::string unit = findings.error_unit.empty() ? "" : " " + findings.error_unit;
    const std::string line = !digit.changed
                                 ? "the same: " + name(digit.b)
                                 : (digit.told_apart ? "changed" : "changed, within the noise of the clock") +
                                       std::string(": ") + name(digit.a) + " -> " + name(digit.b);
    text += wrapped(line, "  " + padded(rounded_text(digit.error, 3) + unit, 8) + " ", "    ");
  }
  return text;
}

std::string front_lines(const Comparison& found) {
  std::string text;
  for (const std::string& label : found.entered) text += wrapped(label, "on the front of B alone: ", "  ");
  for (const std::string& label : found.left) text += wrapped(label, "on the front of A alone: ", "  ");
  return text.empty() ? "the front holds the same cases\n" : text;
}

std::string expectation_lines(const Comparison& found) {
  std::string text;
  for (const ComparedExpectation& one : found.expectations) {
    text += wrapped(one.where + ": " + one.key + " " + one.expected + ": found " + one.found,
                    one.mended ? "holds again " : "FAILS now ", "  ");
  }
  return text;
}

std::string origin_line(const std::string& name, const StoredStudy& study) {
  const Provenance& from = study.findings.provenance;
  return wrapped(one_line(study.file) + ": " + study.findings.title + "; assay " + from.version + ", " + from.git,
                 name + "  ", "   ");
}

std::string counted(int count, const std::string& one, const std::string& many) {
  return count == 0 ? std::string() : ", " + std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::vector<std::string> words_of(const ComparedCase& one) {
  switch (one.standing) {
    case Standing::new_failure:
      return {"NEW FAILURE", one.outcome_b};
    case Standing::fixed:
      return {"fixed", "was " + one.outcome_a};
    case Standing::still_fails:
      return {"still fails", one.outcome_b};
    case Standing::only_in_a:
      return {"ONLY IN A", one.outcome_a};
    case Standing::only_in_b:
      return {"only in B", one.outcome_b};
    case Standing::compared:
      break;
  }
  std::vector<std::string> words;
  if (one.error.trend != 0) words.emplace_back(one.error.trend > 0 ? "LESS ACCURATE" : "more accurate");
  if (one.cost.trend != 0) words.emplace_back(one.cost.trend > 0 ? "SLOWER" : "faster");
  if (words.empty()) words.emplace_back("same");
  return words;
}

std::string ratio_text(const ComparedFigure& figure) {
  if (!figure.before || !figure.after || (*figure.before == 0 && *figure.after != 0)) return "-";
  const double ratio = *figure.before == *figure.after ? 1 : *figure.after / *figure.before;
  std::string text = rounded_text(ratio, 3);
  for (int digits = 4; text == "1" && figure.trend != 0 && digits < 9; ++digits) text = rounded_text(ratio, digits);
  return text;
}

std::string noise_text(const ComparedCase& one) {
  if (!one.cost.before || !one.cost.after || !one.cost_judged) return "-";
  const std::string text = rounded_text(100 * one.cost.bound, 2) + " %";
  return one.noise_measured ? text : text + "(1 run)";
}

std::string comparison_verdict(const Comparison& found) {
  const int worse_errors = found.errors(1), better_errors = found.errors(-1);
  const auto same = static_cast<int>(
      std::count_if(found.cases.begin(), found.cases.end(), [](const auto& one) { return one.is_same(); }));
  std::string words =
      counted(found.count(Standing::new_failure), "new failure", "new failures") +
      counted(found.broken(), "expectation that fails now", "expectations that fail now") +
      counted(found.count(Standing::only_in_a), "case only in A", "cases only in A") +
      counted(worse_errors, "less accurate", "less accurate") + counted(found.costs(1), "slower", "slower") +
      counted(found.count(Standing::fixed), "fixed", "fixed") +
      counted(found.broken(true), "expectation that holds again", "expectations that hold again") +
      counted(better_errors, "more accurate", "more accurate") + counted(found.costs(-1), "faster", "faster") +
      counted(found.count(Standing::only_in_b), "case only in B", "cases only in B") +
      counted(found.count(Standing::still_fails), "still fails", "still fail") + counted(same, "the same", "the same");
  if (words.empty()) words = ", no case in either";
  return (found.is_worse() ? "WORSE: " : "NOTHING WORSE: ") + words.substr(2);
}

std::string comparison_text(const StoredStudy& A, const StoredStudy& B, const Comparison& found, bool all) {
  const StudyFindings& findings = A.findings;
  const std::string unit = findings.cost_unit.empty() ? "" : " [" + findings.cost_unit + "]";
  std::string text = origin_line("A", A) + origin_line("B", B) + wrapped(findings.error_name, "error: ", "  ") +
                     wrapped(findings.cost_name + unit, "cost: ", "  ") + table_of(found, all) +
                     digit_lines(findings, found) + front_lines(found) + expectation_lines(found);
  for (const std::string& warning : found.warnings) text += wrapped(warning, "warning: ", "  ");
  return text + wrapped(comparison_verdict(found), "", "  ");
}

}  // namespace assay::drivers
