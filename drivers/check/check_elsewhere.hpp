// SPDX-License-Identifier: BSD-3-Clause
// What a model does in a process that begins in another way: one that keeps something of its first call shows it.
#pragma once

#include <functional>
#include <optional>

#include "drivers/material/material_choice.hpp"
#include "harness/check/arrays.hpp"

namespace assay::drivers {

/// Rows that `make` gives in a process of its own, which what it does cannot harm; none where that ends before it has
/// given them, or takes longer than limit_s.
std::optional<check::History> made_elsewhere(const std::function<check::History()>& make, double limit_s);

/// The last of the battery's first histories, as the first of a process of its own; empty where that comes to nothing
/// within limit_s. For a process that has not called the model yet.
check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s = 1);

/// The same of other parameters (harness/check/arrays.hpp), from a copy of the library whose first instance has these:
/// a library that was loaded before may keep what its first instance was. Empty, too, of a model that is no native
/// plug-in.
check::History history_of_others(const ResolvedMaterial& material, const check::Effort& effort, double limit_s = 1);

}  // namespace assay::drivers
