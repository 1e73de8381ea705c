// SPDX-License-Identifier: BSD-3-Clause
// The parts of a study's report.html.
#pragma once

#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers::study_page {

/// "Data: NAME", a link to the file beside the page.
std::string data_link(const std::string& file);

/// Escaped, on one line.
std::string unbroken(const std::string& text);

/// A cell of running text.
std::string words_cell(const std::string& text);

// Each is HTML, and empty where the study has nothing of it.
std::string answer(const StudyFindings& findings);           ///< what each digit costs, large
std::string survival_answer(const StudyFindings& findings);  ///< which methods live through most, large
std::string survival_map(const StudyFindings& findings);
std::string survival(const StudyFindings& findings);
std::string verdict(const StudyFindings& findings);
std::string work_precision(const StudyFindings& findings);
std::string pareto(const StudyFindings& findings);
std::string digits(const StudyFindings& findings);
std::string histories(const StudyFindings& findings);
std::string orders(const StudyFindings& findings);
std::string stability(const StudyFindings& findings);
std::string budget(const StudyFindings& findings);
std::string profile(const StudyFindings& findings);
std::string expectations(const StudyFindings& findings);
std::string unfinished(const StudyFindings& findings);
std::string warnings(const StudyFindings& findings);
std::string work_instead(const StudyFindings& findings);
std::string clock(const StudyFindings& findings);
std::string provenance(const StudyFindings& findings);

}  // namespace assay::drivers::study_page
