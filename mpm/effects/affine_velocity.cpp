// SPDX-License-Identifier: BSD-3-Clause
// APIC and AFLIP: the velocity around a particle, from the grid's new one.
#include "mpm/kernels/affine.hpp"
#include "mpm/step/effect.hpp"
#include "mpm/step/passes.hpp"

namespace assay::mpm {

namespace {

/// Gradient: C = L (I + dt L)^-1 so that an affine motion of the grid is the particle's after it has moved; L = B D^-1
/// (fits_gradient) or sum v_i (x) grad phi_ip; total: C = dF/dt. Moment: B = sum phi_ip v_i (x) r_i, of which
/// particles_to_grid makes C = B D^-1.
template <int Dim>
Pass<Dim> affine_pass(const Method& method) {
  const bool moment = method.affine == Affine::moment, total = method.is_total(), fits = fits_gradient(method);
  return {{.name = "affine",
           .slot = {Phase::to_particles, Part::last},
           .doc = moment  ? "first moment of the grid velocity around the particles"
                  : total ? "gradient of the grid velocity"
                  : fits  ? "gradient fitted to the grid velocity around the particles, convected"
                          : "gradient of the grid velocity, convected",
           .reads = {Column::weights},
           .writes = {Column::affine},
           .grid_fields = {"velocity"}},
          [=](State<Dim>& s) {
            const Kernels<Dim>& k = kernels_for(s);
            return over_blocks(s, moment ? k.moment : total ? k.gradient : fits ? k.fitted : k.convected);
          }};
}

/// The first moment of the initial velocity, whose gradient the column holds before the first step.
template <int Dim>
Pass<Dim> first_affine_moment_pass() {
  return {{.name = "first_affine_moment",
           .slot = {Phase::weights, Part::last},
           .doc = "first moment of the initial velocity around the particles",
           .called_for_by = "method.affine",
           .reads = {Column::weights, Column::affine},
           .writes = {Column::affine},
           .once = true},
          [](State<Dim>& s) { return over_blocks(s, kernels_for(s).first_moment); }};
}

template <int Dim>
std::vector<Pass<Dim>> affine_passes(const Setup<Dim>& setup) {
  const Method& method = setup.method;
  std::vector<Pass<Dim>> passes;
  if (method.affine == Affine::moment) passes.push_back(first_affine_moment_pass<Dim>());
  if (affine_column(method) == Column::affine && !fits_with_corners<Dim>(method)) {
    passes.push_back(affine_pass<Dim>(method));
  }
  return passes;
}

template <int Dim>
Mat<Dim> initial_velocity_gradient(const Setup<Dim>& setup, const Vector3& X) {
  if (setup.initial_velocity) return setup.initial_velocity->gradient;
  Tensor rate;
  if (setup.frame) {
    rate = setup.frame->seen((*setup.motion)->at(setup.frame->body_point(X), 0), 0).F_rate;
  } else {
    rate = (*setup.motion)->at(X, 0).F_rate;
  }
  Mat<Dim> gradient;  // by x, which is X
  for (int c = 0; c < Dim * Dim; ++c) gradient[static_cast<std::size_t>(c)] = rate(c / Dim, c % Dim);
  return gradient;
}

template <int Dim>
void begin_affine_velocity(State<Dim>& s) {
  if (!s.setup.motion && !s.setup.initial_velocity) return;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vector3 X = Vector3::Zero();
    for (int d = 0; d < Dim; ++d) X(d) = s.column(Column::reference_position, d)[p];
    const Mat<Dim> C = initial_velocity_gradient(s.setup, X);
    for (int c = 0; c < Dim * Dim; ++c) s.column(affine_column(s.method), c)[p] = C[static_cast<std::size_t>(c)];
  }
}

}  // namespace

template <int Dim>
EffectRecord<Dim> affine_velocity_effect() {
  EffectRecord<Dim> effect{130, "particles carry the velocity around them", "method.transfer"};
  effect.called_for = [](const Setup<Dim>& s) { return s.method.is_affine(); };
  effect.passes = affine_passes<Dim>;
  effect.prepare = begin_affine_velocity<Dim>;
  effect.columns = {{Column::affine, "affine", "mixed",
                     "velocity around the particle: its gradient, or its first moment",
                     [](const Setup<Dim>&) { return doubles(tensor_components<Dim>); }}};
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> affine_velocity_effect();

}  // namespace assay::mpm
