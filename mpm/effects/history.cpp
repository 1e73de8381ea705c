// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/material/stress_blocks.hpp"
#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> history_effect() {
  EffectRecord<Dim> effect{110, "state variables of the material", "material.adapter"};
  effect.called_for = [](const Setup<Dim>& s) { return s.material->state_size() > 0; };
  effect.columns = {{Column::history, "history", "mixed", "state variables of the material, begin and end of the step",
                     [](const Setup<Dim>& s) { return 2 * s.material->state_size() * sizeof(double); }, of_stress}};
  effect.prepare = [](State<Dim>& s) {
    auto& history = s.template own<MaterialHistory>();
    const auto memory = s.setup.offload ? s.setup.offload->allocate : nullptr;
    const int components = static_cast<int>(s.setup.material->state_size());
    for (ColumnData* half : {&history.begin, &history.end}) half->allocate(s.particles, components, memory);
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> history_effect();

}  // namespace assay::mpm
