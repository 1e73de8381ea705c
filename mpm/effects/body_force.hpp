// SPDX-License-Identifier: BSD-3-Clause
// What the effects of the body force have in common.
#pragma once

#include "harness/exact/space_instant.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

/// The pass without its kernel: it writes b.
template <int Dim>
Pass<Dim> unbound_body_force();

/// The exact fields at the particles' reference positions, in the plane on request on the means over their domains; in
/// space as the setup's frame sees them.
template <int Dim>
std::shared_ptr<InstantOf<Dim>> fields_of_particles(const State<Dim>& s, const Asked& asked,
                                                    Evaluation evaluation = Evaluation::point);

/// The same at other places, which live as long as the fields.
template <int Dim>
std::shared_ptr<InstantOf<Dim>> fields_at(const State<Dim>& s, const std::array<std::span<const double>, Dim>& X,
                                          const Asked& asked);

/// b of the exact motion.
template <int Dim>
Kernel body_force_kernel(State<Dim>& s, Evaluation evaluation);

/// v += dt a, and of affine transfers C += dt grad a (by the current position; in the total formulation by the
/// reference one), a of the exact motion at the particle's reference position; b <- b - a [m/s^2]. Needs b. The virtual
/// stress wants it, too.
template <int Dim>
Pass<Dim> inertia_pass(const Method& method, bool accounts);

}  // namespace assay::mpm
