// SPDX-License-Identifier: BSD-3-Clause
// What the effects of the body force have in common. They live in the plane; three dimensions serve the property tests
// of transfer and stress.
#pragma once

#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// The pass without its kernel: it writes b.
Pass<2> unbound_body_force();

/// The exact fields at the particles' reference positions, or on the means over their domains.
std::shared_ptr<ExactInstant> fields_of_particles(const State<2>& s, const Asked& asked,
                                                  Evaluation evaluation = Evaluation::point);

/// b of the exact motion.
Kernel body_force_kernel(State<2>& s, Evaluation evaluation);

/// v += dt a, and of affine transfers C += dt grad a (by the current position; in the total formulation by the
/// reference one), a of the exact motion at the particle's reference position; b <- b - a [m/s^2]. Needs b. The virtual
/// stress wants it, too.
Pass<2> inertia_pass(const Method& method, bool accounts);

}  // namespace assay::mpm
