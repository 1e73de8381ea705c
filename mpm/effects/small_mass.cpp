// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "mpm/data/dimension.hpp"
#include "mpm/effects/passes_remedies.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
void share_forces(State<Dim>& s, double whole, double kick) {
  std::array<double, Dim> left{};
  s.live.each([&](std::size_t i) {
    const double m = s.inertia.node(i)[0], least = whole * s.images.share(i);
    if (!(m > 0 && m < least)) return;
    double* force = s.force.node(i);
    for (std::size_t d = 0; d < Dim; ++d) {
      left[d] += kick * (1 - m / least) * force[d];
      force[d] *= m / least;
    }
  });
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] -= left[d];
}

}  // namespace

template <int Dim>
Pass<Dim> small_mass_pass() {
  Pass<Dim> pass;
  pass.name = "small_mass";
  pass.slot = {Phase::grid, Part::limit};
  pass.doc = "light nodes take up force in proportion to their mass";
  pass.called_for_by = "remedies.small_mass";
  pass.grid_fields = {"mass", "force"};
  pass.bind = [](State<Dim>& s) -> Kernel {
    const double least = s.setup.remedies.small_mass * s.setup.density * std::pow(s.setup.grid.spacing, Dim);
    return [&s, least](const Instant& now) { share_forces(s, least, now.kick); };
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> small_mass_pass<ASSAY_DIMENSION>();

template <int Dim>
EffectRecord<Dim> small_mass_effect() {
  EffectRecord<Dim> effect{220, "light nodes take up force in proportion to their mass", "remedies.small_mass"};
  effect.called_for = [](const Setup<Dim>& s) { return s.remedies.small_mass > 0; };
  effect.passes = [](const Setup<Dim>&) { return std::vector{small_mass_pass<Dim>()}; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> small_mass_effect();

}  // namespace assay::mpm
