// SPDX-License-Identifier: BSD-3-Clause
// Passes of prescribed tractions.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

constexpr Effect effect_of(TractionAlgorithm algorithm) {
  using enum TractionAlgorithm;
  return algorithm == edges              ? Effect::edge_traction
         : algorithm == particles        ? Effect::particle_traction
         : algorithm == undeformed_edges ? Effect::undeformed_traction
                                         : Effect::virtual_stress;
}

/// Tractions of the exact motion to the grid's forces; with accounts their impulse, too. Not of virtual stress.
Pass<2> traction_pass(const Method& method, const Traction& traction, bool accounts);

/// Work of the tractions with the velocity that they leave.
Pass<2> traction_work_pass(TractionAlgorithm algorithm);

/// The particles' stress without that of the exact motion: what internal forces are made of. On the exact state nothing
/// is left, inside and on the surface. The reference form takes off the exact P.
Pass<2> virtual_stress_pass(TractionForm form);

}  // namespace assay::mpm
