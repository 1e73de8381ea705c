// SPDX-License-Identifier: BSD-3-Clause
// From axes to the combinations of their values.
#pragma once

#include <vector>

#include "drivers/study/study.hpp"

namespace assay::drivers {

/// One combination: where it stands on every axis that it has a value of, and what that sets.
struct Combination {
  std::vector<AxisValue> values;
  std::vector<Setting> settings;
};

/// All that the study samples and does not exclude: the full product with the last axis fastest, the list, or a Latin
/// hypercube, in which each axis is cut into as many equal parts as there are cases and each part is taken once. The
/// same study gives the same combinations everywhere. Throws InputError where there are none or too many.
std::vector<Combination> combinations_of(const Study& study);

inline constexpr std::size_t most_combinations = 100000;

}  // namespace assay::drivers
