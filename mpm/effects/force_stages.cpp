// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/passes_mass.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> force_stages_effect() {
  EffectRecord<Dim> effect{170, "several evaluations of the forces in a step", "method.integrator"};
  effect.called_for = [](const Setup<Dim>& s) { return s.method.has_stages(); };
  effect.passes = [](const Setup<Dim>& s) {
    std::vector<Pass<Dim>> passes = inversion_passes(s);
    passes.push_back(force_pass<Dim>(s.method, s.body_force));
    return passes;
  };
  effect.grid_fields = inversion_fields<Dim>;
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> force_stages_effect();

}  // namespace assay::mpm
