// SPDX-License-Identifier: BSD-3-Clause
// study.json, what a study found for machines and for `recommend` and `compare`, and where it lies.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

/// The first two keys of the file.
inline constexpr const char* study_format = "assay study";
inline constexpr int study_version = 1;

/// The whole of study.json, indented, with a newline at the end. Every key is always present; figures that were not
/// reached or are not finite are null.
std::string study_json(const StudyFindings& findings);

/// {share, timed, disturbed, noticeable} of load_of(); share is null where no case was timed.
nlohmann::ordered_json load_json(const StudyFindings& findings);

/// Reads it back: every finite number is the same, bit for bit; null where a number must be is NaN. `file` stands for
/// the text in errors. Throws InputError where the text is torn, no study.json, or of another version or shape: missing
/// keys, other types, indices of cases that are not there, eligible cases without error, or without both cost and work.
StudyFindings findings_of_json(const std::string& text, const std::string& file);

/// Findings and where they were found.
struct StoredStudy {
  std::string folder;  ///< holds study.json and cases/KEY; "" is the working directory
  std::string file;    ///< study.json
  StudyFindings findings;

  /// "results/x/cases/KEY"; empty of a case that has none.
  std::string case_folder(const StudyCase& one) const;
};

/// Reads study.json. `given`: its folder, the file itself, or the study's YAML file, whose results lie in `out`, or in
/// results/NAME where that is empty. Throws InputError: nothing there, no study.json, `out` without a YAML file.
StoredStudy stored_study(const std::string& given, const std::string& out = {});

}  // namespace assay::drivers
