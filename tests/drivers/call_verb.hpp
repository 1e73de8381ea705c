// SPDX-License-Identifier: BSD-3-Clause
// The command line, called in this process.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "drivers/command_line/command_line.hpp"

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

}  // namespace assay::drivers
