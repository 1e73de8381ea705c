// SPDX-License-Identifier: BSD-3-Clause
// Two or three principal stretches that are equal, or nearly so: where a spectral form divides by their difference.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Equal stretches along two axes, or three, that are no axes of the frame; in the plane one of two is its normal. One
/// of them is longer by `difference`.
Tensor equal_stretches(const Space& space, double amplitude, bool three, double difference);

/// Stretches that differ by 0, 1e-15, ... 1e-4 along axes of any direction: the stress changes no more than they do.
TestResult nearly_equal_stretches(const Specimen& specimen);

/// A rotation at equal stretches, as rotation_at_fixed_stretch.
TestResult rotation_at_equal_stretches(const Specimen& specimen);

}  // namespace assay::check
