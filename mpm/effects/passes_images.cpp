// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/effects/passes_images.hpp"

#include <array>

#include "mpm/data/dimension.hpp"

namespace assay::mpm {

namespace {

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
void remember_inertia(State<Dim>& s) {
  UnfoldedSums& sums = s.unfolded;
  sums.image_mass.clear();
  for (const auto& image : s.images.list()) sums.image_mass.push_back(s.inertia.node(image.node)[0]);
  sums.momentum = sum_of(s.inertia, s.live, 1, Dim);
}

/// The particles' gain of momentum against what they were given: by the nodes' velocities and accelerations as shares.
template <int Dim>
void book_planes(State<Dim>& s, const Reaction& share, double kick) {
  for (std::size_t d = 0; d < Dim; ++d) {
    double by_velocity = 0, by_acceleration = 0;
    s.live.each([&](std::size_t i) {
      const double m = s.inertia.node(i)[0];
      by_velocity += m * s.motion.node(i)[d];
      by_acceleration += m * kick * s.motion.node(i)[Dim + d];
    });
    for (std::size_t k = 0; k < s.images.list().size(); ++k) {  // whose mass is counted with their nodes
      const auto& image = s.images.list()[k];
      const double *own = s.motion.node(image.node), *of = s.motion.node(image.of), m = s.unfolded.image_mass[k];
      by_velocity += m * (own[d] - of[d]);
      by_acceleration += m * kick * (own[Dim + d] - of[Dim + d]);
    }
    const double impulse = kick * s.unfolded.force[d];
    s.ledger.impulse[d] += share.of_velocity * (by_velocity - s.unfolded.momentum[d] - impulse) +
                           share.of_acceleration * (by_acceleration - impulse);
  }
}

}  // namespace

template <int Dim>
Pass<Dim> fold_images_pass(Folded what, bool accounts) {
  Pass<Dim> pass;
  pass.name = "fold_images";
  pass.doc = "what nodes beyond symmetry planes or periodic ends were given, to those that they are images of";
  pass.called_for_by = "body";
  pass.effects = {Effect::images};
  pass.grid_fields = {"mass", "momentum"};
  if (what != Folded::inertia) pass.grid_fields.push_back("force");
  pass.bind = [what, accounts](State<Dim>& s) -> Kernel {
    return [&s, what, accounts](const Instant& now) {
      const bool is_new = what != Folded::forces && !(s.method.has_stages() && now.kick != 0);
      if (accounts && is_new) remember_inertia(s);
      s.images.fold(s.inertia, 1);
      if (what == Folded::inertia) return;
      if (accounts) s.unfolded.force = sum_of(s.force, s.live, 0, Dim);
      s.images.fold(s.force);
    };
  };
  return pass;
}

template <int Dim>
Pass<Dim> unfold_images_pass(Reaction reaction, bool accounts) {
  Pass<Dim> pass;
  pass.name = "unfold_images";
  pass.doc = "nodes beyond symmetry planes or periodic ends move as their images";
  pass.called_for_by = "body";
  pass.effects = {Effect::images};
  pass.grid_fields = {"velocity", "acceleration"};
  pass.bind = [reaction, accounts](State<Dim>& s) -> Kernel {
    return [&s, reaction, accounts](const Instant& now) {
      s.images.unfold(s.motion);
      if (accounts) book_planes(s, reaction, now.kick);
    };
  };
  return pass;
}

template Pass<ASSAY_DIMENSION> fold_images_pass<ASSAY_DIMENSION>(Folded, bool);
template Pass<ASSAY_DIMENSION> unfold_images_pass<ASSAY_DIMENSION>(Reaction, bool);

}  // namespace assay::mpm
