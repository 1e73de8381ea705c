// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/data/dimension.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> history_effect() {
  EffectRecord<Dim> effect{110, "state variables of the material", "material.adapter"};
  effect.called_for = [](const Setup<Dim>& s) { return s.material->state_size() > 0; };
  effect.columns = {{Column::history, "history", "mixed", "state variables of the material, begin and end of the step",
                     [](const Setup<Dim>& s) { return 2 * s.material->state_size() * sizeof(double); }, true}};
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> history_effect();

}  // namespace assay::mpm
