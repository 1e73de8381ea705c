// SPDX-License-Identifier: BSD-3-Clause
// The top of a study's report: what each digit costs, whether all holds, and the work-precision picture.
#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/picture/drawing.hpp"
#include "drivers/study/clock.hpp"
#include "drivers/study/study_report_sections.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/study/work_precision_plot.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

std::string step_between(const StudyFindings& findings, const StudyDigit& digit, double before) {
  return "<div class=\"step\">" + factor_text(*digit.factor) + " " +
         element("small", "at exactly " + escaped(error_text(findings, before)) + " \u2192 " +
                              escaped(error_text(findings, digit.error))) +
         "</div>\n";
}

std::string tile_of(const StudyFindings& findings, const StudyDigit& digit) {
  const std::string level = element("span class=\"level\"", "For " + escaped(error_text(findings, digit.error)));
  if (!digit.best) {
    return "<div class=\"digit missed\">" + level + element("b", html::none) +
           element("small", "no case of this study is as accurate") + "</div>\n";
  }
  const StudyCase& best = findings.cases[*digit.best];
  std::string out = "<div class=\"digit\">" + level +
                    element("b", digit.cost ? escaped(cost_text(findings, *digit.cost)) : html::none) +
                    element("span class=\"who\"", escaped(best.series));
  const std::string resolution = resolution_text(findings, best);
  if (!resolution.empty()) out += element("span", escaped(resolution));
  if (best.error) out += element("small", "error measured: " + escaped(error_text(findings, *best.error)));
  if (digit.interpolated) {
    out += element("small", "\u2248 " + escaped(cost_text(findings, *digit.interpolated)) + " at exactly " +
                                escaped(error_text(findings, digit.error)));
  }
  return out + "</div>\n";
}

std::string also_measured(const StudyFindings& findings, CostAxis axis) {
  std::string names;
  for (const WorkCurve& curve : work_precision(findings, axis).curves) {
    if (curve.color || curve.runs.empty()) continue;
    const std::string note = curve.exact ? " (dashed: not eligible, as it uses the exact solution)" : "";
    names += (names.empty() ? "" : "; ") + escaped(curve.name) + note;
  }
  return names.empty() ? "" : " Thin grey lines: " + names + ".";
}

/// The series of the crosses.
std::string crossed(const StudyFindings& findings) {
  std::vector<std::string> names;
  for (const StudyCase& one : findings.cases) {
    const bool known = std::find(names.begin(), names.end(), one.series) != names.end();
    if (!known && !one.budget && !one.completed() && (one.cost || one.work)) names.push_back(one.series);
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? ": " : "; ") + escaped(name);
  return text;
}

std::string picture(const StudyFindings& findings, CostAxis axis) {
  const std::string best = axis == CostAxis::cost ? escaped(findings.cost_name) : "particle-steps";
  return "<figure class=\"lead\">" + svg_text(work_precision_plot(findings, axis)) +
         element("figcaption",
                 "Down and to the left is better. Cases in grey discs are on the front: no other case is both more "
                 "accurate and cheaper in " +
                     best + ". Crosses: cases that ended early, at their cost so far" + crossed(findings) + "." +
                     also_measured(findings, axis)) +
         "</figure>\n" + data_link("work_precision.csv");
}

}  // namespace

std::string data_link(const std::string& file) {
  return "<p class=\"data\">Data: <a href=\"" + file + "\">" + file + "</a></p>\n";
}

std::string unbroken(const std::string& text) {
  std::string out;
  for (const char c : escaped(text)) out += c == ' ' ? std::string("\u00a0") : std::string(1, c);
  return out;
}

std::string words_cell(const std::string& text) { return element("td class=\"words\"", escaped(text)); }

std::string answer(const StudyFindings& findings) {
  std::string out;
  const StudyDigit* before = nullptr;
  for (const StudyDigit& digit : findings.digits) {
    if (before && digit.factor && digit.best) out += step_between(findings, digit, before->error);
    out += tile_of(findings, digit);
    before = &digit;
    if (!digit.best) break;  // nor is any case more accurate than that
  }
  if (out.empty() && findings.front.empty() && !findings.cases.empty()) {
    out = "<div class=\"digit missed\">" + element("b", "No answer") +
          element("small", "no completed case is eligible for the front" + rest_words(findings)) + "</div>\n";
  }
  return out.empty() ? out : "<div class=\"answer\">\n" + out + "</div>\n";
}

std::string verdict(const StudyFindings& findings) {
  const auto failed = std::count_if(findings.expect.begin(), findings.expect.end(),
                                    [](const auto& line) { return !line.outcome.holds; });
  const int missing = findings.count("missing");
  std::string kind = "plain", sentence = "The study has no expectations";
  if (failed > 0) {
    kind = "bad";
    sentence = std::to_string(failed) + " of " + std::to_string(findings.expect.size()) + " expectations " +
               (failed == 1 ? "does" : "do") + " not hold";
  } else if (missing > 0) {
    kind = "bad";
    sentence = "The study is not complete";
  } else if (!findings.expect.empty()) {
    kind = "good";
    sentence = "All expectations hold";
  }
  std::string tally = std::to_string(findings.cases.size()) + " cases: ";
  bool first = true;
  for (const char* outcome :
       {"completed", "unstable", "material_failed", "refused", "crashed", "stopped", "missing", "n/a"}) {
    const int count = findings.count(outcome);
    if (count == 0) continue;
    std::string word = outcome;
    std::replace(word.begin(), word.end(), '_', ' ');
    tally += (first ? "" : ", ") + std::to_string(count) + " " + word;
    first = false;
  }
  const std::string load = load_sentence(findings);
  return "<div class=\"verdict " + kind + "\">" + element("strong", sentence) + element("p", tally + ".") +
         (load.empty() ? "" : element("p", escaped(load))) + "</div>\n";
}

std::string work_precision(const StudyFindings& findings) {
  const std::string swipe =
      "<p class=\"swipe\">Scroll sideways, or open <a href=\"work_precision.svg\">the figure alone</a>.</p>\n";
  return html::section("What accuracy costs", swipe + picture(findings, CostAxis::cost));
}

std::string work_instead(const StudyFindings& findings) {
  const bool any = std::any_of(findings.cases.begin(), findings.cases.end(), [](const auto& one) { return one.work; });
  return any && findings.cost_key != work_key
             ? html::section("The same in particle-steps, without a clock", picture(findings, CostAxis::work))
             : "";
}

}  // namespace assay::drivers::study_page
