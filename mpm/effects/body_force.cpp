// SPDX-License-Identifier: BSD-3-Clause
// b of the exact motion at the particles' reference positions, at the time at which the step begins.
#include "mpm/effects/body_force.hpp"

#include "harness/exact/box_force.hpp"
#include "harness/exact/inertia.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

ReferenceDomains domains_of_setup(const Setup<2>& setup) {
  return setup.seeds.domains ? *setup.seeds.domains : rectangles_of(setup.seeds, *ring_of(*setup.motion));
}

Kernel box_kernel(State<2>& s, Evaluation evaluation) {
  const Point half = evaluation == Evaluation::point ? Point{} : s.setup.seeds.half_size;
  std::vector<Rectangle> places;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Point X{s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p]};
    places.push_back({{X[0] - half[0], X[1] - half[1]}, {X[0] + half[0], X[1] + half[1]}});
  }
  const auto stress = *s.setup.exact->box();
  auto force = std::make_shared<BoxForce>(*stress, s.setup.density, places);
  return [&s, stress, force](const Instant& now) {
    stress->set_time(now.t);
    force->evaluate(*stress, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                    std::span(s.column(Column::body_force, 1), s.particles));
  };
}

Pass<2> unbound_body_force() {
  Pass<2> pass;
  pass.name = "body_force";
  pass.slot = {Phase::body_force};
  pass.stages = Stages::kicks;
  pass.writes = {Column::body_force};
  return pass;
}

namespace {

/// b = a: where F is the same everywhere, and where the virtual stress leaves no more of b.
Kernel acceleration_kernel(State<2>& s) {
  const std::span X(s.column(Column::reference_position, 0), s.particles),
      Y(s.column(Column::reference_position, 1), s.particles);
  auto field = std::make_shared<InertiaField>(*s.setup.motion, 0, X, Y);
  Kernel kernel;
  kernel.begin = [field](const Instant& now) { field->set_time(now.t); };
  kernel.block = [&s, field](const Instant&, const Block& block) {
    const auto b = components<2>(s, Column::body_force);
    for (std::size_t p = block.begin; p < block.end; ++p) {
      const auto a = field->at(p).a;
      for (std::size_t d = 0; d < 2; ++d) b[d][p] = a[d];
    }
    return none_bad;
  };
  return kernel;
}

Kernel point_kernel(State<2>& s) {
  if (is_box(*s.setup.motion)) return box_kernel(s, Evaluation::point);
  const std::size_t n = s.particles;
  auto field = std::make_shared<BodyForceField>(*s.setup.motion, s.setup.density,
                                                std::span(s.column(Column::reference_position, 0), n),
                                                std::span(s.column(Column::reference_position, 1), n));
  return [&s, field, n](const Instant& now) {
    field->evaluate(*s.setup.response, now.t, std::span(s.column(Column::body_force, 0), n),
                    std::span(s.column(Column::body_force, 1), n));
  };
}

std::vector<Pass<2>> body_force_passes(const Setup<2>& setup) {
  Pass<2> pass = unbound_body_force();
  const bool is_acceleration = setup.force_is_acceleration();  // no stress is left in it
  pass.doc = is_acceleration ? "b of the exact motion, which is its acceleration"
                             : "b of the exact motion at the particles' reference positions";
  pass.called_for_by = "force.response";
  pass.reads = {Column::reference_position};
  pass.bind = is_acceleration ? acceleration_kernel : point_kernel;
  return {pass};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> body_force_effect() {
  EffectRecord<Dim> effect{10, "the body force b of the exact motion acts on the particles", "force.response"};
  effect.called_for = [](const Setup<Dim>& s) { return Dim == 2 && s.body_force; };
  if constexpr (Dim == 2) effect.passes = body_force_passes;
  effect.columns = {{Column::body_force, "body_force", "m/s^2", "b of the exact motion",
                     [](const Setup<Dim>&) { return doubles(Dim); }}};
  effect.around = "the response from which b is computed";
  return effect;
}

template EffectRecord<2> body_force_effect();
template EffectRecord<3> body_force_effect();

}  // namespace assay::mpm
