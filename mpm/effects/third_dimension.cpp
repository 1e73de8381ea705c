// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/effect.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> third_dimension_effect() {
  EffectRecord<Dim> effect{250, "particles in space, not in plane strain", ""};
  effect.called_for = [](const Setup<Dim>& s) { return s.seeds.X.size() > 2; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> third_dimension_effect();

}  // namespace assay::mpm
