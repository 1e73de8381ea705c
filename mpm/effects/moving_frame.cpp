// SPDX-License-Identifier: BSD-3-Clause
// The body force as a spinning frame sees it.
#include "mpm/effects/body_force.hpp"

namespace assay::mpm {

namespace {

/// Turns b into the frame and adds the Coriolis and centrifugal terms.
template <int Dim>
Pass<Dim> turning_pass(const Setup<Dim>& setup) {
  Pass<Dim> pass;
  pass.name = "moving_frame";
  pass.slot = {Phase::body_force, Part::last};
  pass.stages = Stages::kicks;
  pass.doc = "b turned into the spinning frame, with its Coriolis and centrifugal terms";
  pass.reads = {Column::reference_position, Column::body_force};
  pass.writes = {Column::body_force};
  pass.bind = [evaluation = setup.evaluation](State<Dim>& s) -> Kernel {
    const Frame spinning{0, s.setup.frame->spin};  // the angle is in the positions
    const auto own = fields_of_particles<Dim>(s, {.motion = true}, evaluation);
    return [&s, spinning, own](const Instant& now) {
      own->set_time(now.t);
      see_body_force(spinning, *own, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                     std::span(s.column(Column::body_force, 1), s.particles));
    };
  };
  return pass;
}

/// In place of the pass that is there: in space b is always that of the exact motion as the frame sees it.
template <int Dim>
Pass<Dim> seen_force_pass(const Setup<Dim>& setup) {
  Pass<Dim> pass = unbound_body_force<Dim>();
  pass.doc = "b of the exact motion as the spinning frame sees it, with its Coriolis and centrifugal terms";
  pass.reads = {Column::reference_position};
  const Evaluation evaluation = setup.averages_force() ? Evaluation::domain_average : Evaluation::point;
  pass.bind = [evaluation](State<Dim>& s) { return body_force_kernel(s, evaluation); };
  return pass;
}

}  // namespace

template <int Dim>
EffectRecord<Dim> moving_frame_effect() {
  EffectRecord<Dim> effect{30, "Coriolis and centrifugal terms of a frame that spins", "frame.spin"};
  effect.called_for = [](const Setup<Dim>& s) { return s.body_force && s.frame && s.frame->spin != 0; };
  effect.passes = [](const Setup<Dim>& s) -> std::vector<Pass<Dim>> {
    if constexpr (Dim == 2) return {turning_pass(s)};
    if constexpr (Dim == 3) return {seen_force_pass(s)};
  };
  return effect;
}

template EffectRecord<ASSAY_DIMENSION> moving_frame_effect();

}  // namespace assay::mpm
