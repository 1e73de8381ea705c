// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/effect.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

template <int Dim>
EffectRecord<Dim> stress_first_effect() {
  EffectRecord<Dim> effect{180, "the stress is updated before the forces", "method.update"};
  effect.called_for = [](const Setup<Dim>& s) { return s.method.update == Update::usf; };
  effect.passes = [](const Setup<Dim>& s) {
    return std::vector{grid_velocity_pass<Dim>(s.method), velocity_gradient_pass<Dim>(s.method),
                       force_pass<Dim>(s.method, s.body_force)};
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> stress_first_effect();

}  // namespace assay::mpm
