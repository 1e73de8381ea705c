// SPDX-License-Identifier: BSD-3-Clause
// The top of the report of a study that asks which method lives through most.
#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/picture/drawing.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_report_sections.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/study/survival.hpp"

namespace assay::drivers::study_page {

using html::element;

namespace {

std::string completed_text(const Survival& of) {
  return std::to_string(of.completed) + " of " + std::to_string(of.asked());
}

std::string lost_text(const Survival& of) {
  std::string text;
  if (of.died > 0) text += std::to_string(of.died) + " failed";
  if (of.unfinished > 0) text += (text.empty() ? "" : ", ") + std::to_string(of.unfinished) + " not ended";
  if (of.refused > 0) text += (text.empty() ? "" : ", ") + std::to_string(of.refused) + " refused";
  if (of.not_applicable > 0) text += (text.empty() ? "" : ", ") + std::to_string(of.not_applicable) + " n/a";
  return text;
}

}  // namespace

std::string survival_answer(const StudyFindings& findings) {
  constexpr std::size_t tiles = 4;
  const std::vector<Survival> methods = survivals(findings);
  std::string out;
  for (std::size_t k = 0; k < std::min(tiles, methods.size()); ++k) {
    const Survival& of = methods[k];
    out += std::string("<div class=\"digit") + (of.completed == of.asked() ? "" : " missed") + "\">" +
           element("b", completed_text(of)) + element("span class=\"who\"", escaped(of.method));
    if (of.error_ratio) {
      out +=
          element("small", "error " + escaped(html::figure(of.error_ratio, 3)) + " times the smallest, in the median");
    }
    out += element("small", escaped(lost_text(of))) + "</div>\n";
  }
  return out.empty() ? out : "<div class=\"answer\">\n" + out + "</div>\n";
}

std::string survival_map(const StudyFindings& findings) {
  if (findings.cases.empty()) return {};
  return html::section("The map", "<figure class=\"map\">" + svg_text(stability_picture(stability_map(findings))) +
                                      "</figure>\n" + data_link("stability.svg"));
}

std::string survival(const StudyFindings& findings) {
  std::vector<std::vector<std::string>> rows;
  const std::vector<Survival> methods = survivals(findings);
  for (const Survival& of : methods) {
    rows.push_back({escaped(of.method), completed_text(of), std::to_string(of.died), std::to_string(of.refused),
                    std::to_string(of.not_applicable), html::figure(of.error_ratio, 3)});
  }
  if (rows.empty()) return {};
  return html::section("Which method completes the most cases",
                       html::table({"method", "completed", "failed", "refused", "n/a", "error over the best"}, rows) +
                           element("p class=\"tally\"", "Error over the best: " + escaped(ratio_note) + ". " +
                                                            escaped(unfinished_note(methods))));
}

}  // namespace assay::drivers::study_page
