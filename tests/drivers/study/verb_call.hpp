// SPDX-License-Identifier: BSD-3-Clause
// The command line, called with studies that are made up.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/command_line/command_line.hpp"
#include "drivers/study/analysis/study_json.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers {

struct VerbOutcome {
  int status = 0;
  std::string out, err;
  /// Bad input: status 2, nothing on standard output, one line on standard error.
  bool is_refusal() const { return status == 2 && out.empty() && std::count(err.begin(), err.end(), '\n') == 1; }
};

inline VerbOutcome call_verb(std::vector<std::string> words) {
  words.insert(words.begin(), "assay");
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  VerbOutcome outcome;
  outcome.status = command_line(static_cast<int>(words.size()), argv.data());
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

/// Writes study.json into a folder of that name; returns the folder.
inline std::string study_in(const ScratchFolder& scratch, const std::string& name, const StudyFindings& findings) {
  std::filesystem::create_directories(scratch / name);
  scratch.write(name + "/study.json", study_json(findings));
  return scratch / name;
}

}  // namespace assay::drivers
