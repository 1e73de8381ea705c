// SPDX-License-Identifier: BSD-3-Clause
// What a model does in a process that begins in another way: one that keeps something of its first call shows it.
#pragma once

#include "harness/check/arrays.hpp"

namespace assay::drivers {

/// The last of the battery's first histories, as the first of a process of its own; empty where that comes to nothing
/// within limit_s. For a process that has not called the model yet.
check::History history_elsewhere(const Material& material, const check::Effort& effort, double limit_s = 1);

}  // namespace assay::drivers
