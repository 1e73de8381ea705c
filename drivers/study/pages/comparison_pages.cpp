// SPDX-License-Identifier: BSD-3-Clause
// What `assay compare` says.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "drivers/result/json_fields.hpp"
#include "drivers/study/analysis/study_json.hpp"
#include "drivers/study/pages/document.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

/// How a case stands, in words, and of which study they name the outcome.
struct StandingWords {
  const char *words, *before = "";
  std::string ComparedCase::*outcome = nullptr;
};

const StandingWords& words_for(Standing standing) {
  static const std::map<Standing, StandingWords> all{
      {Standing::compared, {""}},
      {Standing::new_failure, {"NEW FAILURE", "", &ComparedCase::outcome_b}},
      {Standing::fixed, {"fixed", "was ", &ComparedCase::outcome_a}},
      {Standing::still_fails, {"still fails", "", &ComparedCase::outcome_b}},
      {Standing::only_in_a, {"ONLY IN A", "", &ComparedCase::outcome_a}},
      {Standing::only_in_b, {"only in B", "", &ComparedCase::outcome_b}},
  };
  return all.at(standing);
}

/// "NEW FAILURE", "unstable"; "slower", "less accurate"; "same": what is said of a case, a line each.
std::vector<std::string> words_of(const ComparedCase& one) {
  const StandingWords& standing = words_for(one.standing);
  if (standing.outcome) return {standing.words, standing.before + one.*standing.outcome};
  std::vector<std::string> words;
  if (one.error.trend != 0) words.emplace_back(one.error.trend > 0 ? "LESS ACCURATE" : "more accurate");
  if (one.cost.trend != 0) words.emplace_back(one.cost.trend > 0 ? "SLOWER" : "faster");
  if (words.empty()) words.emplace_back("same");
  return words;
}

/// The smallest difference of cost that counts, "6 %"; "25 %(1 run)"; "-".
std::string noise_text(const ComparedCase& one) {
  if (!one.cost.a || !one.cost.b || !one.cost_judged) return "-";
  return rounded_text(100 * one.cost.bound, 2) + (one.noise_measured ? " %" : " %(1 run)");
}

const char* change_text(const ComparedDigit& digit) {
  return !digit.changed ? "the same" : digit.told_apart ? "changed" : "changed, within the noise of the clock";
}

std::string in_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

constexpr std::size_t label_width = 32, words_width = 17, ratio_width = 10;

/// Lines of at most the label's column, less a blank.
std::vector<std::string> label_lines(const std::string& label) {
  const std::string text = wrapped(label, "", "  ", label_width - 1);
  return mapped(split(stripped(text, "\n"), '\n'), [](const std::string& line) {
    return line.size() < label_width ? line : one_line(line, label_width - 4);
  });
}

std::string comparison_line(const std::string& label, const std::string& words, const std::string& error,
                            const std::string& cost, const std::string& noise) {
  return table_line(padded(label, label_width) + padded(words, words_width) + padded(error, ratio_width) +
                    padded(cost, ratio_width) + noise);
}

std::string comparison_lines(const ComparedCase& one) {
  std::vector<std::string> label = label_lines(one.label), words = words_of(one);
  label.resize(std::max(label.size(), words.size()));
  words.resize(label.size());
  std::string lines = comparison_line(label[0], words[0], ratio_text(one.error), ratio_text(one.cost), noise_text(one));
  for (std::size_t i = 1; i < label.size(); ++i) lines += comparison_line(label[i], words[i], "", "", "");
  return lines;
}

std::string table_of(const Comparison& found, bool all) {
  std::string rows;
  for (const ComparedCase& one : found.cases) {
    if (all || !one.is_same()) rows += comparison_lines(one);
  }
  if (rows.empty()) return {};
  return "\n" + comparison_line("case", "B against A", "error B/A", "cost B/A", "noise") + rows;
}

std::string digit_lines(const StudyFindings& findings, const Comparison& found) {
  if (found.digits.empty()) return {};
  const auto name = [](const std::string& label) { return label.empty() ? std::string("none") : label; };
  std::string text = "\nthe cheapest case at an error of\n";
  for (const ComparedDigit& digit : found.digits) {
    const std::string unit = findings.error_unit.empty() ? "" : " " + findings.error_unit;
    text += wrapped(change_text(digit) + (": " + (digit.changed ? name(digit.a) + " -> " : "")) + name(digit.b),
                    "  " + padded(rounded_text(digit.error, 3) + unit, 8) + " ", "    ");
  }
  return text;
}

std::string front_lines(const Comparison& found) {
  std::string text;
  for (const std::string& label : found.entered) text += wrapped(label, "on the front of B alone: ", "  ");
  for (const std::string& label : found.left) text += wrapped(label, "on the front of A alone: ", "  ");
  return text.empty() ? "the front holds the same cases\n" : text;
}

std::string origin_line(const std::string& name, const StoredStudy& study) {
  const Provenance& from = study.findings.provenance;
  return wrapped(one_line(study.file) + ": " + study.findings.title + "; assay " + from.version + ", " + from.git,
                 name + "  ", "   ");
}

/// A cell of a table in Markdown.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : one_line(text)) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped.empty() ? "-" : escaped;
}

std::string cell(const Figure& value) { return value ? rounded_text(*value, 4) : "-"; }

Json study_origin(const StoredStudy& study) {
  const Provenance& from = study.findings.provenance;
  return Json::object(
      {{"file", study.file}, {"title", study.findings.title}, {"version", from.version}, {"git", from.git}});
}

}  // namespace

std::string ratio_text(const ComparedFigure& figure) {
  if (!figure.a || !figure.b || (*figure.a == 0 && *figure.b != 0)) return "-";
  const double ratio = *figure.a == *figure.b ? 1 : *figure.b / *figure.a;
  std::string text = rounded_text(ratio, 3);
  for (int digits = 4; text == "1" && figure.trend != 0 && digits < 9; ++digits) text = rounded_text(ratio, digits);
  return text;
}

std::string comparison_verdict(const Comparison& found) {
  const auto same = static_cast<int>(std::ranges::count_if(found.cases, [](const auto& one) { return one.is_same(); }));
  struct Count {
    int count;
    const char *one, *many;
  };
  std::string words;
  for (const auto& [count, one, many] :
       {Count{found.count(Standing::new_failure), "new failure", "new failures"},
        {found.broken(), "expectation that fails now", "expectations that fail now"},
        {found.count(Standing::only_in_a), "case only in A", "cases only in A"},
        {found.errors(1), "less accurate", "less accurate"},
        {found.costs(1), "slower", "slower"},
        {found.count(Standing::fixed), "fixed", "fixed"},
        {found.broken(true), "expectation that holds again", "expectations that hold again"},
        {found.errors(-1), "more accurate", "more accurate"},
        {found.costs(-1), "faster", "faster"},
        {found.count(Standing::only_in_b), "case only in B", "cases only in B"},
        {found.count(Standing::still_fails), "still fails", "still fail"},
        {same, "the same", "the same"}}) {
    if (count > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, count == 1 ? one : many);
  }
  return (found.is_worse() ? "WORSE: " : "NOTHING WORSE: ") + (words.empty() ? "no case in either" : words);
}

std::string comparison_text(const StoredStudy& A, const StoredStudy& B, const Comparison& found, bool all) {
  const StudyFindings& findings = A.findings;
  std::string text = origin_line("A", A) + origin_line("B", B) + wrapped(findings.error_name, "error: ", "  ") +
                     wrapped(in_unit(findings.cost_name, findings.cost_unit), "cost: ", "  ") + table_of(found, all) +
                     digit_lines(findings, found) + front_lines(found);
  for (const ComparedExpectation& one : found.expectations) {
    text += wrapped(one.where + ": " + one.key + " " + one.expected + ": found " + one.found,
                    one.holds ? "holds again " : "FAILS now ", "  ");
  }
  for (const std::string& warning : found.warnings) text += wrapped(warning, "warning: ", "  ");
  return text + wrapped(comparison_verdict(found), "", "  ");
}

std::string comparison_markdown(const StoredStudy& A, const StoredStudy& B, const Comparison& found) {
  const StudyFindings& findings = A.findings;
  std::string page = "**" + comparison_verdict(found) + "**\n\n";
  page += "A: `" + one_line(A.file) + "` (" + A.findings.provenance.git + "), B: `" + one_line(B.file) + "` (" +
          B.findings.provenance.git + "). Error: " + in_unit(findings.error_name, findings.error_unit) +
          ". Cost: " + in_unit(findings.cost_name, findings.cost_unit) + ".\n\n";
  page += "| Case | B against A | Error A | Error B | B/A | Cost A | Cost B | B/A | Noise |\n";
  page += "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ComparedCase& one : found.cases) {
    page += markdown_line({cell(one.label), cell(joined(words_of(one))), cell(one.error.a), cell(one.error.b),
                           ratio_text(one.error), cell(one.cost.a), cell(one.cost.b), ratio_text(one.cost),
                           noise_text(one)});
  }
  if (!found.digits.empty()) page += "\n| Error | Cheapest in A | Cheapest in B | |\n| --- | --- | --- | --- |\n";
  for (const ComparedDigit& digit : found.digits)
    page += markdown_line({rounded_text(digit.error, 3), cell(digit.a), cell(digit.b), change_text(digit)});
  if (!found.expectations.empty()) page += "\n";
  for (const ComparedExpectation& one : found.expectations)
    page += std::string(one.holds ? "- holds again: " : "- **fails now**: ") + one_line(one.where) + ": `" + one.key +
            "` " + one.expected + ", found " + one.found + "\n";
  if (!found.warnings.empty()) page += "\n";
  for (const std::string& warning : found.warnings) page += "- Warning: " + warning + "\n";
  return page;
}

std::string comparison_json(const StoredStudy& A, const StoredStudy& B, const Comparison& found) {
  Json out;
  out["worse"] = found.is_worse();
  out["verdict"] = comparison_verdict(found);
  out["a"] = study_origin(A);
  out["b"] = study_origin(B);
  out["cases"] = JsonFields<Json>::of(found.cases);
  out["digits"] = JsonFields<Json>::of(found.digits);
  out["front"] = Json::object({{"entered", found.entered}, {"left", found.left}});
  out["expectations"] = JsonFields<Json>::of(found.expectations);
  out["warnings"] = found.warnings;
  out["load"] = Json::object({{"a", load_json(A.findings)}, {"b", load_json(B.findings)}});
  return json_document(out);
}

}  // namespace assay::drivers
