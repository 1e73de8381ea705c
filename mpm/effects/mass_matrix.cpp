// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/passes_mass.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> mass_matrix_effect() {
  EffectRecord<Dim> effect{160, "consistent mass, or a series of its inverse", "method.mass"};
  effect.called_for = [](const Setup<Dim>& s) { return s.method.mass != Mass::lumped; };
  effect.passes = inversion_passes<Dim>;
  effect.grid_fields = inversion_fields<Dim>;
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> mass_matrix_effect();

}  // namespace assay::mpm
