// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "mpm/step/effect.hpp"

namespace assay::mpm {

struct SmallMass {
  double least = 0;  ///< 0: all forces
};

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

/// Runs before the grid moves. A node that is lighter than the scene says keeps only its share of the force.
template <int Dim>
Pass<Dim> small_mass_pass() {
  return {{.name = "small_mass",
           .slot = {Phase::grid, Part::limit},
           .doc = "light nodes take up force in proportion to their mass",
           .grid_fields = {"mass", "force"}},
          [](State<Dim>& s) -> Kernel {
            const double least =
                option<SmallMass>(s.setup).least * s.setup.density * std::pow(s.setup.grid.spacing, Dim);
            return [&s, &images = s.template own<Images<Dim>>(), least](const Instant& now) {
              share_forces(s, images, least, now.kick);
            };
          }};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> small_mass_effect() {
  EffectRecord<Dim> effect{220, "light nodes take up force in proportion to their mass", "remedies.small_mass"};
  effect.called_for = [](const Setup<Dim>& s) { return option<SmallMass>(s).least > 0; };
  effect.keys = [](EffectOptions& options, Keys& key) {
    auto& own = options.tell<SmallMass>();
    key("remedies.small_mass", "nodes lighter than this receive less force, in proportion to their mass [rho0 h^2]",
        own.least,
        {.range = {.lower = 0, .upper = 1, .lower_open = true}, .derived = "all forces", .shown = own.least > 0});
  };
  effect.example = "0.1";
  effect.refusal = [](const Method& method, const EffectOptions&) -> std::string {
    if (method.is_lumped()) return {};
    return "looks at the mass of single nodes, and the mass matrix couples them: take mass: lumped";
  };
  effect.in_title = [](const EffectOptions&) -> std::string { return "small masses"; };
  effect.passes = [](const Setup<Dim>&) { return std::vector{small_mass_pass<Dim>()}; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> small_mass_effect();

}  // namespace assay::mpm
