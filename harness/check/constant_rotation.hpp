// SPDX-License-Identifier: BSD-3-Clause
// A frame that is turned once for all: what any model keeps exactly.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Orientation of the frame from the beginning on; sigma = Q sigma_0 Q^T.
TestResult constant_rotation(const Specimen& specimen);

/// The same of a stretch along axes that stand still, which no spin enters: whether it is right.
bool right_without_spin(const Specimen& specimen);

}  // namespace assay::check
