// SPDX-License-Identifier: BSD-3-Clause
// Where the findings of a study lie.
#pragma once

#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

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
