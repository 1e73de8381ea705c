// SPDX-License-Identifier: BSD-3-Clause
// The pass on the particles alone.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// F <- (I + dt L) F, then the material's update in batches; finds det F <= 0 and failed points.
template <int Dim>
Pass<Dim> stress_pass(bool with_history);

}  // namespace assay::mpm
