// SPDX-License-Identifier: BSD-3-Clause
// Symmetry planes and periodic ends.
#include <array>

#include "mpm/step/effect.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Of all nodes before images were folded: for the accounts.
struct UnfoldedSums {
  std::vector<double> image_mass;             ///< of each image [kg]
  std::array<double, 3> momentum{}, force{};  ///< [N s], [N]
};

template <int K, int Dim>
std::array<double, 3> sum_of(const GridField<K>& field, const LiveNodes<Dim>& live, int first, int count) {
  std::array<double, 3> sum{};
  live.each([&](std::size_t i) {
    for (int d = 0; d < count; ++d) sum[static_cast<std::size_t>(d)] += field.node(i)[first + d];
  });
  return sum;
}

/// Mass and momentum that nodes have been given, before images are folded.
template <int Dim>
void remember_inertia(const State<Dim>& s, const Images<Dim>& images, UnfoldedSums& sums) {
  sums.image_mass.clear();
  for (const auto& image : images.list()) sums.image_mass.push_back(s.inertia.node(image.node)[0]);
  sums.momentum = sum_of(s.inertia, s.live, 1, Dim);
}

/// The particles' gain of momentum against what they were given: by the nodes' velocities and accelerations as shares.
template <int Dim>
void book_planes(State<Dim>& s, const Images<Dim>& images, const UnfoldedSums& sums, const Reaction& share,
                 double kick) {
  for (std::size_t d = 0; d < Dim; ++d) {
    double by_velocity = 0, by_acceleration = 0;
    s.live.each([&](std::size_t i) {
      const double m = s.inertia.node(i)[0];
      by_velocity += m * s.motion.node(i)[d];
      by_acceleration += m * kick * s.motion.node(i)[Dim + d];
    });
    for (std::size_t k = 0; k < images.list().size(); ++k) {  // whose mass is counted with their nodes
      const auto& image = images.list()[k];
      const double *own = s.motion.node(image.node), *of = s.motion.node(image.of), m = sums.image_mass[k];
      by_velocity += m * (own[d] - of[d]);
      by_acceleration += m * kick * (own[Dim + d] - of[Dim + d]);
    }
    const double impulse = kick * sums.force[d];
    s.ledger.impulse[d] += share.of_velocity * (by_velocity - sums.momentum[d] - impulse) +
                           share.of_acceleration * (by_acceleration - impulse);
  }
}

/// What particles gave to images goes to the nodes of which they are.
template <int Dim>
Pass<Dim> fold_images_pass(Phase phase, Folded what, bool accounts) {
  Pass<Dim> pass{
      {.name = "fold_images",
       .slot = {phase, Part::fold},
       .doc = "what nodes beyond symmetry planes or periodic ends were given, to those that they are images of",
       .grid_fields = {"mass", "momentum"}}};
  if (what != Folded::inertia) pass.grid_fields.push_back("force");
  pass.bind = [what, accounts](State<Dim>& s) -> Kernel {
    return [&s, &images = s.template own<Images<Dim>>(), &sums = s.template own<UnfoldedSums>(), what,
            accounts](const Instant& now) {
      const bool is_new = what != Folded::forces && !(s.method.has_stages() && now.kick != 0);
      if (accounts && is_new) remember_inertia(s, images, sums);
      images.fold(s.inertia, 1);
      if (what == Folded::inertia) return;
      if (accounts) sums.force = sum_of(s.force, s.live, 0, Dim);
      images.fold(s.force);
    };
  };
  return pass;
}

/// Images move as their nodes do. With the reaction of what a plane does to the particles' momentum where accounts are
/// kept.
template <int Dim>
Pass<Dim> unfold_images_pass(Phase phase, Reaction reaction, bool accounts) {
  return {{.name = "unfold_images",
           .slot = {phase, Part::unfold},
           .doc = "nodes beyond symmetry planes or periodic ends move as their images",
           .grid_fields = {"velocity", "acceleration"}},
          [reaction, accounts](State<Dim>& s) -> Kernel {
            return [&s, &images = s.template own<Images<Dim>>(), &sums = s.template own<UnfoldedSums>(), reaction,
                    accounts](const Instant& now) {
              images.unfold(s.motion);
              if (accounts) book_planes(s, images, sums, reaction, now.kick);
            };
          }};
}

template <int Dim>
std::vector<Pass<Dim>> image_passes(const Setup<Dim>& setup) {
  std::vector<Pass<Dim>> passes;
  for (const GridPhase& grid : grid_phases(setup.method)) {
    passes.push_back(fold_images_pass<Dim>(grid.phase, grid.folded, setup.accounts));
    const bool accounts = setup.accounts && grid.phase == Phase::grid;
    passes.push_back(unfold_images_pass<Dim>(grid.phase, grid.reaction, accounts));
  }
  return passes;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> images_effect() {
  EffectRecord<Dim> effect{90, "symmetry planes and periodic ends", "body"};
  effect.called_for = [](const Setup<Dim>& s) { return s.has_images(); };
  effect.passes = image_passes<Dim>;
  effect.prepare = [](State<Dim>& s) { s.template own<Images<Dim>>() = Images<Dim>(s.setup.grid, s.setup.ends); };
  effect.around = "pairs of nodes";
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> images_effect();

}  // namespace assay::mpm
