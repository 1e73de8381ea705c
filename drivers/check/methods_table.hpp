// SPDX-License-Identifier: BSD-3-Clause
// Which method passes which patch test, as a table in Markdown.
#pragma once

#include <string>

#include "drivers/check/methods_report.hpp"

namespace assay::drivers {

/// The tests that all methods pass by name, then one row for methods that agree in all others and one column for tests
/// that agree in all rows. A row holds every transfer that it names, with every basis and formulation that it names.
std::string methods_markdown(const CheckedMethods& checked);

}  // namespace assay::drivers
