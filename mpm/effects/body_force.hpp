// SPDX-License-Identifier: BSD-3-Clause
// What the effects of the body force have in common. They live in the plane; three dimensions serve the property tests
// of transfer and stress.
#pragma once

#include "harness/exact/domain_average.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// The pass without its kernel: it writes b.
Pass<2> unbound_body_force();

/// Over which b is averaged.
ReferenceDomains domains_of_setup(const Setup<2>& setup);

/// Of the axis-aligned motion: its series, at points or on the mean over the domains.
Kernel box_kernel(State<2>& s, Evaluation evaluation);

}  // namespace assay::mpm
