// SPDX-License-Identifier: BSD-3-Clause
// `assay check --replay`: one failure again, alone.
#pragma once

#include "drivers/check/check.hpp"

namespace assay::drivers {

/// Takes the step of a replay file again, as it is and from a turned frame, then the test that failed. Returns 1 where
/// it fails again, 0 where it does not. Throws InputError.
int check_replay(const CheckOptions& options);

}  // namespace assay::drivers
