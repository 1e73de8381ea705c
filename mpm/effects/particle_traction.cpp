// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> particle_traction_effect() {
  EffectRecord<Dim> effect{70, "tractions at the particles of the surface", "traction.algorithm"};
  effect.called_for = [](const Setup<Dim>& s) { return has_traction(s, TractionAlgorithm::particles); };
  if constexpr (Dim == 2) effect.passes = traction_passes;
  effect.asks_material = true;
  effect.around = "loads of the surface";
  return effect;
}

template EffectRecord<2> particle_traction_effect();
template EffectRecord<3> particle_traction_effect();

}  // namespace assay::mpm
