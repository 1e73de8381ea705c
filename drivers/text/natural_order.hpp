// SPDX-License-Identifier: BSD-3-Clause
// The order that people expect of numbered files.
#pragma once

#include <string>

namespace assay::drivers {

/// Names by the numbers in them: "dump.9" before "dump.10". Names that differ in leading zeros alone are equal.
bool in_natural_order(const std::string& a, const std::string& b);

}  // namespace assay::drivers
