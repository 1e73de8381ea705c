// SPDX-License-Identifier: BSD-3-Clause
// What `check` finds out about one material: the battery, and around it what a foreign interface leaves open.
#pragma once

#include "drivers/check/check_material.hpp"

namespace assay::drivers {

/// Into `checked`: the report, and what the answer depends on. What the material was taken for instead, where its
/// description leaves open what the answers settle.
std::optional<ResolvedMaterial> judge(const ResolvedMaterial& material, const CheckSettings& settings,
                                      const CheckReporter& reporter, CheckedMaterial& checked);

}  // namespace assay::drivers
