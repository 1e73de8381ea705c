// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/tractions.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> undeformed_traction_effect() {
  EffectRecord<Dim> effect{80, "tractions by the undeformed length of the edges", "traction.algorithm"};
  effect.called_for = [](const Setup<Dim>& s) { return has_traction(s, TractionAlgorithm::undeformed_edges); };
  if constexpr (Dim == 2) effect.passes = traction_passes;
  effect.asks_material = true;
  effect.around = "loads of the surface";
  return effect;
}

template EffectRecord<2> undeformed_traction_effect();
template EffectRecord<3> undeformed_traction_effect();

}  // namespace assay::mpm
