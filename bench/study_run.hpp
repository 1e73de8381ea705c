// SPDX-License-Identifier: BSD-3-Clause
// One run of a study.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/output_folder.hpp"
#include "drivers/result.hpp"

namespace assay::drivers {

/// What `assay run FILE --set ...` finds on one thread, screened alike; nothing but pictures is left in the folder.
Result result_of(const std::string& file, const std::vector<std::string>& sets, OutputFolder& folder);

/// Four digits, or nothing where there is no figure.
std::string text_of(const Figure& figure);

}  // namespace assay::drivers
