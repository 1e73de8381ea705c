// SPDX-License-Identifier: BSD-3-Clause
// b of the exact motion at the particles' reference positions, at the time at which the step begins.
#include "mpm/effects/body_force.hpp"

#include <stdexcept>

#include "mpm/data/blocks.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

std::shared_ptr<ExactInstant> fields_of_particles(const State<2>& s, const Asked& asked, Evaluation evaluation) {
  if (!s.setup.exact) throw std::invalid_argument("what a step needs of the exact motion has no exact solution");
  ExactPoints points{std::span(s.column(Column::reference_position, 0), s.particles),
                     std::span(s.column(Column::reference_position, 1), s.particles)};
  if (evaluation == Evaluation::domain_average) {
    points.half = s.setup.seeds.half_size;
    points.domains = s.setup.seeds.domains;
  }
  return s.setup.exact->instant(points, asked);
}

Kernel body_force_kernel(State<2>& s, Evaluation evaluation) {
  const auto fields = fields_of_particles(s, {.force = true}, evaluation);
  const InPieces pieces = [threads = s.setup.threads](std::size_t n, const auto& body) {
    for_blocks(n, threads, body);
  };
  return [&s, fields, pieces](const Instant& now) {
    fields->set_time(now.t);
    fields->body_force(std::span(s.column(Column::body_force, 0), s.particles),
                       std::span(s.column(Column::body_force, 1), s.particles), pieces);
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
  const auto fields = fields_of_particles(s, {.inertia = true});
  Kernel kernel;
  kernel.begin = [fields](const Instant& now) { fields->set_time(now.t); };
  kernel.block = [&s, fields](const Instant&, const Block& block) {
    const auto b = components<2>(s, Column::body_force);
    for (std::size_t p = block.begin; p < block.end; ++p) {
      const auto a = fields->inertia(p).a;
      for (std::size_t d = 0; d < 2; ++d) b[d][p] = a[d];
    }
    return none_bad;
  };
  return kernel;
}

std::vector<Pass<2>> body_force_passes(const Setup<2>& setup) {
  Pass<2> pass = unbound_body_force();
  const bool is_acceleration = setup.force_is_acceleration();  // no stress is left in it
  pass.doc = is_acceleration ? "b of the exact motion, which is its acceleration"
                             : "b of the exact motion at the particles' reference positions";
  pass.reads = {Column::reference_position};
  pass.bind = [is_acceleration](State<2>& s) {
    return is_acceleration ? acceleration_kernel(s) : body_force_kernel(s, Evaluation::point);
  };
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
