// SPDX-License-Identifier: BSD-3-Clause
// The inertia of the exact motion given to the particles themselves, so that the grid carries the rest of b alone.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// v += dt a, and of affine transfers C += dt grad a (by the current position; in the total formulation by the
/// reference one), a of the exact motion at the particle's reference position; b <- b - a [m/s^2]. Needs b. The virtual
/// stress wants it, too.
Pass<2> inertia_pass(const Method& method, bool accounts);

}  // namespace assay::mpm
