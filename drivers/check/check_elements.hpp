// SPDX-License-Identifier: BSD-3-Clause
// Models that keep a state outside STATEV, one for each element.
#pragma once

#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

/// Whether two bodies, each with an element of its own, are as either of them alone, and with one for both are not.
bool keeps_state_by_element(const ResolvedMaterial& material, double strain, double pressure);

/// Of a model whose same step is not the same again: its cause, where that is a state by element.
void judge_elements(const ResolvedMaterial& material, check::Report& report);

}  // namespace assay::drivers
