// SPDX-License-Identifier: BSD-3-Clause
// b as the mean over each particle's reference domain.
#include "mpm/effects/body_force.hpp"

namespace assay::mpm {

namespace {

/// In place of the one at points.
std::vector<Pass<2>> averaging_passes(const Setup<2>&) {
  Pass<2> pass = unbound_body_force();
  pass.doc = "b of the exact motion, averaged over the particles' reference domains";
  pass.bind = [](State<2>& s) { return body_force_kernel(s, Evaluation::domain_average); };
  return {pass};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> averaging_effect() {
  EffectRecord<Dim> effect{20, "b is the mean over each particle's reference domain", "force.evaluation"};
  effect.called_for = [](const Setup<Dim>& s) { return Dim == 2 && s.averages_force(); };
  if constexpr (Dim == 2) effect.passes = averaging_passes;
  effect.around = "the domains, cut at the ring's edges";
  return effect;
}

template EffectRecord<2> averaging_effect();
template EffectRecord<3> averaging_effect();

}  // namespace assay::mpm
