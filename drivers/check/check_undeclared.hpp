// SPDX-License-Identifier: BSD-3-Clause
// What the description of a foreign model leaves open, and its answers settle: whether it depends on the rate, whether
// it has directions of its own.
#pragma once

#include "drivers/check/check_report.hpp"
#include "drivers/material/material_choice.hpp"

namespace assay::drivers {

/// Whether its description says nothing of `flags`, and the length of a step changes its answer.
bool may_depend_on_rate(const ResolvedMaterial& material, check::Report& report);

/// The same model, with the flag. Throws what Material does.
ResolvedMaterial as_rate_dependent(const ResolvedMaterial& material);

/// Whether the battery finds less of the model with the flag than it did without, and nothing of its clock.
bool settles_rate(const check::Report& with_flag, const check::Report& without);

/// A remark on it in the test of the clock; what the last line says of it.
Dependence say_rate(check::Report& report, double effect);

/// For a model that is not isotropic and whose description says nothing of `symmetry`: that it was taken for isotropic,
/// and whether it passes as one that has directions of its own. For one that fails with fixed axes: whether it passes
/// with axes that turn with the body.
void hint_symmetry(const ResolvedMaterial& material, check::Report& report);

}  // namespace assay::drivers
