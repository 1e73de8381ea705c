// SPDX-License-Identifier: BSD-3-Clause
// Figures of result.json in words.
#pragma once

#include <string>
#include <utility>

namespace assay::drivers {

/// "error.l2_max": "largest L2 error of the displacement", "m"; a key that has no words stands for itself.
std::pair<std::string, std::string> name_and_unit(const std::string& key);

/// 10^k, the double nearest to it.
double rounded_power(int k);

}  // namespace assay::drivers
