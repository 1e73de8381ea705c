// SPDX-License-Identifier: BSD-3-Clause
// What a source compiles with, and its author did not mean.
#pragma once

#include <string>
#include <vector>

#include "drivers/material/source_entry.hpp"

namespace assay::drivers {

/// Sentences on a list of arguments that is not what Abaqus hands over, in their number or by their names in another
/// order; on arguments whose declared size is another: integers of 8 bytes, reals of 4. And on variables that take a
/// property and hold less of it: integers by their first letter, reals of 4 bytes.
std::vector<std::string> entry_traps(const FortranSource& source, const SourceEntry& entry);

/// The same of a symbol, which need not be there.
std::vector<std::string> entry_traps(const FortranSource& source, const std::string& symbol);

}  // namespace assay::drivers
