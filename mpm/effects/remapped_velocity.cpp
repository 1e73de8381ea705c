// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/step/effect.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Momentum once more.
template <int Dim>
Pass<Dim> again_pass(const Method& method) {
  Pass<Dim> pass = particles_to_grid_pass<Dim>(method);
  pass.name = "particles_to_grid_again";
  pass.slot = {gradient_phase(method), Part::first};
  pass.doc = "nodal momentum from the updated particle velocities (MUSL)";
  pass.called_for_by = "method.update";
  return pass;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> remapped_velocity_effect() {
  EffectRecord<Dim> effect{190, "L comes from the updated velocities of the particles", "method.update"};
  effect.called_for = [](const Setup<Dim>& s) { return s.method.update == Update::musl; };
  effect.passes = [](const Setup<Dim>& s) {
    return std::vector{again_pass<Dim>(s.method), grid_velocity_pass<Dim>(s.method),
                       velocity_gradient_pass<Dim>(s.method)};
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> remapped_velocity_effect();

}  // namespace assay::mpm
