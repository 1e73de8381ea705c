// SPDX-License-Identifier: BSD-3-Clause
// b as the mean over each particle's reference domain.
#include "mpm/effects/body_force.hpp"

namespace assay::mpm {

namespace {

/// In place of the one at points.
template <int Dim>
std::vector<Pass<Dim>> averaging_passes(const Setup<Dim>&) {
  Pass<Dim> pass = unbound_body_force<Dim>();
  pass.doc = "b of the exact motion, averaged over the particles' reference domains";
  pass.bind = [](State<Dim>& s) { return body_force_kernel(s, Evaluation::domain_average); };
  return {pass};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> averaging_effect() {
  EffectRecord<Dim> effect{20, "b is the mean over each particle's reference domain", "force.evaluation"};
  effect.called_for = [](const Setup<Dim>& s) { return s.averages_force(); };
  effect.passes = averaging_passes<Dim>;
  effect.around = Dim == 2 ? "the domains, cut at the ring's edges" : "the domains, divided at the vortex's edges";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> averaging_effect();

}  // namespace assay::mpm
