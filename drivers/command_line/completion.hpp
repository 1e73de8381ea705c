// SPDX-License-Identifier: BSD-3-Clause
// What a shell offers where the tab key is pressed: the scripts of completions/ ask for it.
#pragma once

#include <string>
#include <vector>

#include "drivers/command_line/verb.hpp"

namespace assay::drivers {

/// A line for each thing that may stand in place of the last of the words, which follow `assay`: a word, a tab and its
/// meaning; "*.csv" for files of that kind; "*" for all files; "*/" for folders.
std::string completions(const CLI::App& app, const std::vector<AddedVerb>& verbs,
                        const std::vector<std::string>& words);

}  // namespace assay::drivers
