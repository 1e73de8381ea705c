// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "mpm/step/effect.hpp"

namespace assay::mpm {

namespace {

template <int Dim>
void share_forces(State<Dim>& s, const Images<Dim>& images, double whole, double kick) {
  std::array<double, Dim> left{};
  s.live.each([&](std::size_t i) {
    const double m = s.inertia.node(i)[0], least = whole * images.share(i);
    if (!(m > 0 && m < least)) return;
    double* force = s.force.node(i);
    for (std::size_t d = 0; d < Dim; ++d) {
      left[d] += kick * (1 - m / least) * force[d];
      force[d] *= m / least;
    }
  });
  for (std::size_t d = 0; d < Dim; ++d) s.ledger.impulse[d] -= left[d];
}

/// Before the grid moves: of the force on nodes lighter than the setup's small_mass only their share of it is left.
template <int Dim>
Pass<Dim> small_mass_pass() {
  return {{.name = "small_mass",
           .slot = {Phase::grid, Part::limit},
           .doc = "light nodes take up force in proportion to their mass",
           .called_for_by = "remedies.small_mass",
           .grid_fields = {"mass", "force"}},
          [](State<Dim>& s) -> Kernel {
            const double least = s.setup.remedies.small_mass * s.setup.density * std::pow(s.setup.grid.spacing, Dim);
            return [&s, &images = s.template own<Images<Dim>>(), least](const Instant& now) {
              share_forces(s, images, least, now.kick);
            };
          }};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> small_mass_effect() {
  EffectRecord<Dim> effect{220, "light nodes take up force in proportion to their mass", "remedies.small_mass"};
  effect.called_for = [](const Setup<Dim>& s) { return s.remedies.small_mass > 0; };
  effect.passes = [](const Setup<Dim>&) { return std::vector{small_mass_pass<Dim>()}; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> small_mass_effect();

}  // namespace assay::mpm
