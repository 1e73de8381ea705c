// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_report.hpp"

#include "drivers/output/html.hpp"
#include "drivers/study/study_report_sections.hpp"
#include "drivers/study/study_style.hpp"

namespace assay::drivers {

std::string study_report_html(const StudyFindings& findings, const std::vector<ReportPicture>& pictures) {
  using namespace study_page;
  std::string body;
  if (!findings.question.empty()) body += html::element("p class=\"question\"", escaped(findings.question)) + "\n";
  if (findings.asks_survival) {
    body += survival_answer(findings) + verdict(findings) + survival(findings) + survival_map(findings) +
            stability(findings) + expectations(findings) + unfinished(findings) + warnings(findings) +
            histories(findings);
  } else {
    body += answer(findings) + verdict(findings) + work_precision(findings) + pareto(findings) + digits(findings) +
            histories(findings) + orders(findings) + pictures_section(pictures) + stability(findings);
    body += budget(findings) + profile(findings) + expectations(findings) + unfinished(findings) + warnings(findings) +
            work_instead(findings);
  }
  body += clock(findings) + provenance(findings);
  if (!findings.study_yaml.empty()) {
    body += html::section("The study", html::element("pre", escaped(findings.study_yaml)) + "\n");
  }
  const std::string title = findings.title.empty() ? "assay study" : findings.title;
  return html::page(escaped(title), body, study_style);
}

}  // namespace assay::drivers
