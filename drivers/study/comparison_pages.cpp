// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "drivers/result/json_figure.hpp"
#include "drivers/study/comparison_text.hpp"
#include "drivers/study/study_json.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

/// A cell of a table in Markdown.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : one_line(text)) escaped += c == '|' ? "\\|" : std::string(1, c);
  return " " + (escaped.empty() ? "-" : escaped) + " |";
}

std::string figure_cell(const Figure& value) { return cell(value ? rounded_text(*value, 4) : "-"); }

std::string row_of(const ComparedCase& one) {
  return "|" + cell(one.label) + cell(joined(words_of(one))) + figure_cell(one.error.before) +
         figure_cell(one.error.after) + cell(ratio_text(one.error)) + figure_cell(one.cost.before) +
         figure_cell(one.cost.after) + cell(ratio_text(one.cost)) + cell(noise_text(one)) + "\n";
}

std::string in_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

Json compared_json(const ComparedFigure& figure) {
  Json out;
  out["a"] = json_figure(figure.before);
  out["b"] = json_figure(figure.after);
  out["bound"] = json_figure(figure.bound);
  out["trend"] = figure.trend;
  return out;
}

const char* standing_name(Standing standing) {
  switch (standing) {
    case Standing::new_failure:
      return "new_failure";
    case Standing::fixed:
      return "fixed";
    case Standing::still_fails:
      return "still_fails";
    case Standing::only_in_a:
      return "only_in_a";
    case Standing::only_in_b:
      return "only_in_b";
    case Standing::compared:
      break;
  }
  return "compared";
}

Json case_json_of(const ComparedCase& one) {
  Json out;
  out["label"] = one.label;
  out["standing"] = standing_name(one.standing);
  out["worse"] = one.is_worse();
  out["outcome_a"] = json_text(one.outcome_a);
  out["outcome_b"] = json_text(one.outcome_b);
  out["error"] = compared_json(one.error);
  out["cost"] = compared_json(one.cost);
  out["noise_measured"] = one.noise_measured;
  out["cost_judged"] = one.cost_judged;
  return out;
}

Json study_origin(const StoredStudy& study) {
  const Provenance& from = study.findings.provenance;
  return Json::object(
      {{"file", study.file}, {"title", study.findings.title}, {"version", from.version}, {"git", from.git}});
}

}  // namespace

std::string comparison_markdown(const StoredStudy& A, const StoredStudy& B, const Comparison& found) {
  const StudyFindings& findings = A.findings;
  std::string page = "**" + comparison_verdict(found) + "**\n\n";
  page += "A: `" + one_line(A.file) + "` (" + A.findings.provenance.git + "), B: `" + one_line(B.file) + "` (" +
          B.findings.provenance.git + "). Error: " + in_unit(findings.error_name, findings.error_unit) +
          ". Cost: " + in_unit(findings.cost_name, findings.cost_unit) + ".\n\n";
  page += "| Case | B against A | Error A | Error B | B/A | Cost A | Cost B | B/A | Noise |\n";
  page += "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ComparedCase& one : found.cases) page += row_of(one);
  if (!found.digits.empty()) page += "\n| Error | Cheapest in A | Cheapest in B | |\n| --- | --- | --- | --- |\n";
  for (const ComparedDigit& digit : found.digits) {
    page += "|" + cell(rounded_text(digit.error, 3)) + cell(digit.a) + cell(digit.b) +
            cell(!digit.changed     ? "the same"
                 : digit.told_apart ? "changed"
                                    : "changed, within the noise of the clock") +
            "\n";
  }
  if (!found.expectations.empty()) page += "\n";
  for (const ComparedExpectation& one : found.expectations)
    page += std::string(one.mended ? "- holds again: " : "- **fails now**: ") + one_line(one.where) + ": `" + one.key +
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
  out["cases"] = Json::array();
  for (const ComparedCase& one : found.cases) out["cases"].push_back(case_json_of(one));
  out["digits"] = Json::array();
  for (const ComparedDigit& digit : found.digits) {
    out["digits"].push_back(Json::object({{"error", json_figure(digit.error)},
                                          {"a", json_text(digit.a)},
                                          {"b", json_text(digit.b)},
                                          {"changed", digit.changed},
                                          {"told_apart", digit.told_apart}}));
  }
  out["front"] = Json::object({{"entered", found.entered}, {"left", found.left}});
  out["expectations"] = Json::array();
  for (const ComparedExpectation& one : found.expectations) {
    out["expectations"].push_back(Json::object({{"where", one.where},
                                                {"key", one.key},
                                                {"expected", one.expected},
                                                {"found", one.found},
                                                {"holds", one.mended}}));
  }
  out["warnings"] = found.warnings;
  out["load"] = Json::object({{"a", load_json(A.findings)}, {"b", load_json(B.findings)}});
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
