// SPDX-License-Identifier: BSD-3-Clause
// The files that a study leaves beside its cases.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/study/case_store.hpp"
#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// Their names, as OutputFolder takes them.
std::vector<std::string> study_file_names();

/// Report, tables and pictures, all or none. Throws SystemError.
void write_study(const StudyFindings& findings, const CaseStore& store, const std::filesystem::path& folder);

}  // namespace assay::drivers
