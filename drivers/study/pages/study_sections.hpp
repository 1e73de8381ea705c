// SPDX-License-Identifier: BSD-3-Clause
// The parts of a study's document.
#pragma once

#include "drivers/study/analysis/findings.hpp"
#include "drivers/study/pages/document.hpp"

namespace assay::drivers::study_page {

// Of several pages.
Section question(const StudyFindings& findings);  ///< and how error and cost are measured
Section digits(const StudyFindings& findings);
Section front(const StudyFindings& findings);
Section orders(const StudyFindings& findings);
Section survival(const StudyFindings& findings);
Section stability(const StudyFindings& findings);
Section budget(const StudyFindings& findings);
Section expectations(const StudyFindings& findings);
Section unfinished(const StudyFindings& findings);
Section warnings(const StudyFindings& findings);
Section origin(const StudyFindings& findings);  ///< at the end of Markdown

// Of the report alone.
Section answer(const StudyFindings& findings);           ///< what each digit costs, large
Section survival_answer(const StudyFindings& findings);  ///< which methods live through most, large
Section verdict(const StudyFindings& findings);
Section work_precision(const StudyFindings& findings);
Section work_instead(const StudyFindings& findings);  ///< the same picture by particle-steps
Section survival_map(const StudyFindings& findings);
Section histories(const StudyFindings& findings);
Section profile(const StudyFindings& findings);
Section clock(const StudyFindings& findings);
Section provenance(const StudyFindings& findings);
Section text_of_study(const StudyFindings& findings);

/// The data behind other figures, as CSV: orders, stability, cases, histories, clocks, curves, passes.
std::vector<Section> data_tables(const StudyFindings& findings);

/// A section that only one page has, as it stands there.
Section section_of(Page page, const std::string& heading, const std::string& content, const std::string& file = {});

}  // namespace assay::drivers::study_page
