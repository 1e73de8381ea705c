// SPDX-License-Identifier: BSD-3-Clause
// A file of MTest taken along: the same increments, the same comparisons.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/findings/run_options.hpp"

namespace assay::drivers {

/// Whether a file's name ends as those of MTest do: .mtest, .mtest.in.
bool is_mtest(const std::string& file);

struct MtestOptions : SceneOptions {
  std::map<std::string, std::string> placeholders;  ///< values of @library@, ..., by name without the @
  std::string material;                             ///< in place of the behaviour; empty: that
};

/// "library=./lib.so" of --define; throws InputError.
std::map<std::string, std::string> placeholders_of(const std::vector<std::string>& defines);

/// Takes the behaviour through the times of the file, one increment of the model between two, and compares. Leaves
/// path.csv, comparisons.csv and result.json. Returns the exit status: 1 where a comparison fails. Throws InputError:
/// what the file asks for and cannot be served.
int tabulate_mtest(const MtestOptions& options);

}  // namespace assay::drivers
