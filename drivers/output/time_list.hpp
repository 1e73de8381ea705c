// SPDX-License-Identifier: BSD-3-Clause
// Times that an option gives.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

/// Numbers with commas between them, or the name of a file of them: one a line, or CSV with the column t. Throws
/// InputError: none, not finite, below 0.
std::vector<double> read_times(const std::string& given);

/// Whether it names a file.
bool names_file_of_times(const std::string& given);

}  // namespace assay::drivers
