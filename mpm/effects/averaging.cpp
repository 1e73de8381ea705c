// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/data/blocks.hpp"
#include "mpm/effects/body_force.hpp"

namespace assay::mpm {

namespace {

Kernel averaged_kernel(State<2>& s) {
  if (is_box(*s.setup.motion)) return box_kernel(s, Evaluation::domain_average);
  auto field = std::make_shared<DomainAverage>(*s.setup.motion, s.setup.density, domains_of_setup(s.setup));
  const InPieces pieces = [threads = s.setup.threads](std::size_t n, const auto& body) {
    for_blocks(n, threads, body);
  };
  return [&s, field, pieces](const Instant& now) {
    field->evaluate(*s.setup.response, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                    std::span(s.column(Column::body_force, 1), s.particles), pieces);
  };
}

/// In place of the one at points.
std::vector<Pass<2>> averaging_passes(const Setup<2>&) {
  Pass<2> pass = unbound_body_force();
  pass.doc = "b of the exact motion, averaged over the particles' reference domains";
  pass.called_for_by = "force.evaluation";
  pass.bind = averaged_kernel;
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
