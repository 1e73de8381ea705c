// SPDX-License-Identifier: BSD-3-Clause
// UMATs of plane strain or plane stress that are given more components than they serve.
#pragma once

#include "drivers/check/check_process.hpp"

namespace assay::drivers {

/// Of a UMAT that fails, and whose description says nothing of `components`: whether four cure it, or bring another
/// defect to light; its diagnosis says so then. One of plane stress cannot be judged, whatever is said and even where
/// it passes with four: `error`. Throws Interrupted, SystemError.
void judge_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how);

}  // namespace assay::drivers
