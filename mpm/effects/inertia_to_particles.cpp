// SPDX-License-Identifier: BSD-3-Clause
// The inertia of the exact motion given to the particles themselves, so that the grid carries the rest of b alone.
#include "mpm/effects/body_force.hpp"

#include <algorithm>

#include "mpm/data/blocks.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"

namespace assay::mpm {

namespace {

/// d a_i / d x_j by the particle's own F, or by X.
template <int Dim>
Mat<Dim> gradient_of(const State<Dim>& s, std::size_t p, const Mat<Dim>& by_reference) {
  if (s.method.is_total()) return by_reference;
  return product<Dim>(by_reference, inverse<Dim>(s.template at<Dim * Dim>(Column::deformation_gradient, p)));
}

template <int Dim>
void give(State<Dim>& s, const InstantOf<Dim>& field, double kick, std::size_t begin, std::size_t end) {
  const auto v = components<Dim>(s, Column::velocity), b = components<Dim>(s, Column::body_force);
  const auto& here = field.window(begin, end);
  for (std::size_t p = begin; p < end; ++p) {
    const FieldInertia<Dim> inertia = here.inertia(p);
    for (std::size_t d = 0; d < Dim; ++d) {
      v[d][p] += kick * inertia.a[d];
      b[d][p] -= inertia.a[d];
    }
    if (!s.method.is_affine()) continue;
    const auto C = components<Dim * Dim>(s, affine_column(s.method));
    const Mat<Dim> gradient = gradient_of<Dim>(s, p, inertia.gradient);
    for (std::size_t c = 0; c < gradient.size(); ++c) C[c][p] += kick * gradient[c];
  }
}

/// What the particles were given, from the velocities after it.
template <int Dim>
void account(State<Dim>& s, const InstantOf<Dim>& field, double kick) {
  const auto v = components<Dim>(s, Column::velocity), x = components<Dim>(s, Column::position);
  for (std::size_t begin = 0; begin < s.particles; begin += block_size) {
    const std::size_t end = std::min(s.particles, begin + block_size);
    const auto& here = field.window(begin, end);
    for (std::size_t p = begin; p < end; ++p) {
      const double m = kick * s.column(Column::mass)[p];
      const auto a = here.acceleration(p);
      for (std::size_t d = 0; d < Dim; ++d) {
        s.ledger.impulse[d] += m * a[d];
        s.ledger.external_work += m * a[d] * (v[d][p] - 0.5 * kick * a[d]);
      }
      add_moment(s.ledger.angular_impulse, m, load(x, p), a);
    }
  }
}

template <int Dim>
Kernel inertia_kernel(State<Dim>& s, bool accounts) {
  std::shared_ptr<InstantOf<Dim>> field;
  if constexpr (Dim == 2) {
    const ExactPoints points{std::span(s.column(Column::reference_position, 0), s.particles),
                             std::span(s.column(Column::reference_position, 1), s.particles)};
    const ExactSolutionPtr seen = s.setup.frame ? seen_from(*s.setup.frame, s.setup.exact) : s.setup.exact;
    field = seen->instant(points, {.inertia = true});
  } else {
    field = fields_of_particles<Dim>(s, {.inertia = true});
  }
  return [&s, field, accounts](const Instant& now) {
    field->set_time(now.t);
    for_blocks(s.particles, s.setup.threads,
               [&](std::size_t begin, std::size_t end) { give<Dim>(s, *field, now.kick, begin, end); });
    if (accounts) account<Dim>(s, *field, now.kick);
  };
}

}  // namespace

template <int Dim>
Pass<Dim> inertia_pass(const Method& method, bool accounts) {
  Pass<Dim> pass;
  pass.name = "inertia_to_particles";
  pass.slot = {Phase::inertia};
  pass.doc = "a of the exact motion to the particles; b - a is left for the grid";
  pass.reads = {Column::reference_position, Column::velocity, Column::body_force};
  pass.writes = {Column::velocity, Column::body_force};
  if (method.is_affine()) {
    pass.reads.push_back(affine_column(method));
    pass.writes.push_back(affine_column(method));
    if (!method.is_total()) pass.reads.push_back(Column::deformation_gradient);
  }
  if (accounts) pass.reads.insert(pass.reads.end(), {Column::mass, Column::position});
  pass.bind = [accounts](State<Dim>& s) { return inertia_kernel(s, accounts); };
  return pass;
}

template <int Dim>
EffectRecord<Dim> inertia_to_particles_effect() {
  EffectRecord<Dim> effect{40, "particles get the acceleration of the exact motion", "force.inertia"};
  effect.called_for = [](const Setup<Dim>& s) { return s.body_force && s.inertia == Inertia::particles; };
  effect.passes = [](const Setup<Dim>& s) { return std::vector{inertia_pass<Dim>(s.method, s.accounts)}; };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> inertia_to_particles_effect();
template Pass<ASSAY_DIMENSION> inertia_pass(const Method&, bool);

}  // namespace assay::mpm
