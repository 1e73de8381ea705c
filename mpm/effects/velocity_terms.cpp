// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/passes_mass.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> velocity_terms_effect() {
  EffectRecord<Dim> effect{165, "terms of the mass matrix in the velocity, as XPIC and FMPM have", "method.transfer"};
  effect.called_for = [](const Setup<Dim>& s) {
    return s.method.transfer == Transfer::xpic || s.method.transfer == Transfer::fmpm;
  };
  effect.passes = inversion_passes<Dim>;
  effect.grid_fields = inversion_fields<Dim>;
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> velocity_terms_effect();

}  // namespace assay::mpm
