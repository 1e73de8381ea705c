// SPDX-License-Identifier: BSD-3-Clause
// UMATs of plane strain that are given six components because nobody has said so.
#pragma once

#include "drivers/check_process.hpp"

namespace assay::drivers {

/// Of a UMAT that fails, and whose description says nothing of `components`: whether four cure it. Its diagnosis says
/// so then. Throws Interrupted, SystemError.
void hint_components(CheckedMaterial& checked, const check::Effort& effort, const CheckProcesses& how);

}  // namespace assay::drivers
