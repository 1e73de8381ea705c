// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> material_direction_effect() {
  EffectRecord<Dim> effect{120, "each particle's material has a direction of its own", "material.adapter"};
  effect.called_for = [](const Setup<Dim>& s) { return has_direction(s.material->table()); };
  effect.around = "directions at rest, in the history";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> material_direction_effect();

}  // namespace assay::mpm
