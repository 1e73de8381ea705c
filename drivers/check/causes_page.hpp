// SPDX-License-Identifier: BSD-3-Clause
// What the causes mean that a check can name: docs/causes.md, which the build puts into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

/// The whole page, as written.
std::string_view causes_page();

/// The causes that the page has a section for, in its order.
std::vector<std::string> explained_causes();

/// The section of a cause for a terminal of 80 columns: its name, paragraphs that are wrapped, lists and code; empty
/// where the page has none.
std::string explained_cause(const std::string& cause);

/// `check --explain CAUSE`: prints that section; for "all" the list of causes. Throws InputError.
int explain_cause(const std::string& cause);

}  // namespace assay::drivers
