// SPDX-License-Identifier: BSD-3-Clause
// UMATs of plane strain or plane stress that are given six components because nobody has said so.
#pragma once

#include "drivers/check_process.hpp"

namespace assay::drivers {

/// Of a UMAT that fails, and whose description says nothing of `components`: whether four cure it, or bring another
/// defect to light; its diagnosis says so then. One of plane stress cannot be judged: `error`. Throws Interrupted,
/// SystemError.
void judge_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how);

}  // namespace assay::drivers
