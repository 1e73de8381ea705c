// SPDX-License-Identifier: BSD-3-Clause
// Whether the internal energy that a VUMAT counts is the work of its stress.
#pragma once

#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

/// Into the test `energy` of a VUMAT, which offers no energy otherwise: work of shears and of extensions must count
/// alike, whatever density the model divides it by. Nothing of one that counts none.
void judge_energies(const ResolvedMaterial& material, check::Report& report);

}  // namespace assay::drivers
