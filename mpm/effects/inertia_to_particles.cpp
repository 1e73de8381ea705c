// SPDX-License-Identifier: BSD-3-Clause
// The inertia of the exact motion given to the particles themselves, so that the grid carries the rest of b alone.
#include "mpm/effects/body_force.hpp"

#include "mpm/data/blocks.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"

namespace assay::mpm {

namespace {

/// d a_i / d x_j by the particle's own F, or by X.
Mat<2> gradient_of(const State<2>& s, std::size_t p, const Mat<2>& by_reference) {
  if (s.method.is_total()) return by_reference;
  Mat<2> F;
  for (std::size_t c = 0; c < F.size(); ++c) F[c] = s.column(Column::deformation_gradient, static_cast<int>(c))[p];
  return product<2>(by_reference, inverse<2>(F));
}

void give(State<2>& s, const ExactInstant& field, double kick, std::size_t begin, std::size_t end) {
  const auto v = components<2>(s, Column::velocity), b = components<2>(s, Column::body_force);
  for (std::size_t p = begin; p < end; ++p) {
    const PlaneInertia inertia = field.inertia(p);
    for (std::size_t d = 0; d < 2; ++d) {
      v[d][p] += kick * inertia.a[d];
      b[d][p] -= inertia.a[d];
    }
    if (!s.method.is_affine()) continue;
    const auto C = components<4>(s, affine_column(s.method));
    const Mat<2> gradient = gradient_of(s, p, inertia.gradient);
    for (std::size_t c = 0; c < gradient.size(); ++c) C[c][p] += kick * gradient[c];
  }
}

/// What the particles were given, from the velocities after it.
void account(State<2>& s, const ExactInstant& field, double kick) {
  const auto v = components<2>(s, Column::velocity), x = components<2>(s, Column::position);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double m = kick * s.column(Column::mass)[p];
    const auto a = field.inertia(p).a;
    for (std::size_t d = 0; d < 2; ++d) {
      s.ledger.impulse[d] += m * a[d];
      s.ledger.external_work += m * a[d] * (v[d][p] - 0.5 * kick * a[d]);
    }
    s.ledger.angular_impulse += m * (x[0][p] * a[1] - x[1][p] * a[0]);
  }
}

Kernel inertia_kernel(State<2>& s, bool accounts) {
  const ExactPoints points{std::span(s.column(Column::reference_position, 0), s.particles),
                           std::span(s.column(Column::reference_position, 1), s.particles)};
  const ExactSolutionPtr seen = s.setup.frame ? seen_from(*s.setup.frame, s.setup.exact) : s.setup.exact;
  const std::shared_ptr<ExactInstant> field = seen->instant(points, {.inertia = true});
  return [&s, field, accounts](const Instant& now) {
    field->set_time(now.t);
    for_blocks(s.particles, s.setup.threads,
               [&](std::size_t begin, std::size_t end) { give(s, *field, now.kick, begin, end); });
    if (accounts) account(s, *field, now.kick);
  };
}

}  // namespace

Pass<2> inertia_pass(const Method& method, bool accounts) {
  Pass<2> pass;
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
  pass.bind = [accounts](State<2>& s) { return inertia_kernel(s, accounts); };
  return pass;
}

template <int Dim>
EffectRecord<Dim> inertia_to_particles_effect() {
  EffectRecord<Dim> effect{40, "particles get the acceleration of the exact motion", "force.inertia"};
  effect.called_for = [](const Setup<Dim>& s) { return Dim == 2 && s.body_force && s.inertia == Inertia::particles; };
  if constexpr (Dim == 2) {
    effect.passes = [](const Setup<Dim>& s) { return std::vector{inertia_pass(s.method, s.accounts)}; };
  }
  return effect;
}

template EffectRecord<2> inertia_to_particles_effect();
template EffectRecord<3> inertia_to_particles_effect();

}  // namespace assay::mpm
