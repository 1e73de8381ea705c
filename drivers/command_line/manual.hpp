// SPDX-License-Identifier: BSD-3-Clause
// The man page: docs/assay.1, and what it does not say of the verbs.
#pragma once

#include <string>
#include <vector>

#include "drivers/command_line/verb.hpp"

namespace assay::drivers {

/// The page with an entry for each option that the section of its verb does not name, and with a section for each verb
/// that has none, both in the words of the help. page: in roff, a section `.SS assay VERB` for a verb.
std::string whole_manual(const CLI::App& app, const std::vector<AddedVerb>& verbs, std::string page);

}  // namespace assay::drivers
