// SPDX-License-Identifier: BSD-3-Clause
// The command line, called with studies that are made up.
#pragma once

#include <filesystem>
#include <string>

#include "drivers/study/analysis/study_json.hpp"
#include "tests/drivers/call_verb.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers {

/// Writes study.json into a folder of that name; returns the folder.
inline std::string study_in(const ScratchFolder& scratch, const std::string& name, const StudyFindings& findings) {
  std::filesystem::create_directories(scratch / name);
  scratch.write(name + "/study.json", study_json(findings));
  return scratch / name;
}

}  // namespace assay::drivers
