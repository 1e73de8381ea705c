// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drivers/findings/run_options.hpp"

namespace assay::drivers {

/// From a scene to a verdict: leaves its results in the folder and tells of them. Returns the exit status: 0 where all
/// that was expected holds, otherwise 1. Throws InputError, SystemError.
int run(const RunOptions& options);

}  // namespace assay::drivers
