// SPDX-License-Identifier: BSD-3-Clause
// Prescribed tractions: what their algorithms have in common.
#pragma once

#include "mpm/basis/basis.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
bool has_traction(const Setup<Dim>& setup, TractionAlgorithm algorithm) {
  return setup.traction && setup.traction->algorithm == algorithm;
}

/// Tractions of the exact motion to the grid's forces, by all algorithms but virtual stress; with accounts their
/// impulse and work, too.
template <int Dim>
std::vector<Pass<Dim>> traction_passes(const Setup<Dim>& setup);

/// The record of such an algorithm.
template <int Dim, TractionAlgorithm algorithm>
EffectRecord<Dim> traction_effect(int place, const char* doc) {
  EffectRecord<Dim> effect{place, doc, "traction.algorithm"};
  effect.called_for = [](const Setup<Dim>& s) { return has_traction(s, algorithm); };
  effect.passes = traction_passes<Dim>;
  effect.asks_material = true;
  effect.around = "loads of the surface";
  return effect;
}

/// The particles' stress without that of the exact motion: what internal forces are made of. On the exact state nothing
/// is left, inside and on the surface. The reference form takes off the exact P.
template <int Dim>
Pass<Dim> virtual_stress_pass(TractionForm form);

/// Of the stress that forces are made of: USF takes that of the end of the step.
inline double time_of_forces(const Method& method, const Instant& now) {
  return method.update == Update::usf ? now.t + now.dt : now.t;
}

}  // namespace assay::mpm
