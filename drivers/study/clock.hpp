// SPDX-License-Identifier: BSD-3-Clause
// What the readings of a case's clock are worth.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// Of at least one value.
double median(std::vector<double> values);

/// Of the machine's cores: what others keep busy beyond that, a clock may feel.
inline constexpr double disturbing_share = 0.15;

/// Whether the median of the repeats was taken beside others that kept more of the machine busy.
bool is_disturbed(const ClockReadings& clock);

/// "15 % of the machine".
std::string disturbing_text();

/// The number of cores in machine_name(); 1 where it tells none.
int cores_of(const std::string& machine);

}  // namespace assay::drivers
