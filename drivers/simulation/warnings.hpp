// SPDX-License-Identifier: BSD-3-Clause
// What whoever runs a scene has to be told of before it runs.
#pragma once

#include <string>
#include <vector>

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// One sentence each: a time.step beyond a Courant number of 1; stress at rest, which free faces do not bear.
std::vector<std::string> warnings_of(const Problem& problem);

}  // namespace assay::drivers
