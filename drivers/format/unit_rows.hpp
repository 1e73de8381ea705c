// SPDX-License-Identifier: BSD-3-Clause
// Units of a file, chosen by their words.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_values.hpp"
#include "drivers/text/units.hpp"

namespace assay::drivers {

/// `value`: SI units in one of it; not written where no word has it. `words`: units that may be chosen.
YamlRow unit_row(const char* name, double& value, const std::vector<std::string>& words);

/// What a number in an author's units may be.
Range in_units(const Range& si, const Scale& scale);

}  // namespace assay::drivers
