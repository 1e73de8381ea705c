// SPDX-License-Identifier: BSD-3-Clause
// The body force as a spinning frame sees it.
#include "mpm/effects/body_force.hpp"

namespace assay::mpm {

namespace {

/// Turns b into the frame and adds the Coriolis and centrifugal terms.
std::vector<Pass<2>> moving_frame_passes(const Setup<2>& setup) {
  Pass<2> pass;
  pass.name = "moving_frame";
  pass.slot = {Phase::body_force, Part::last};
  pass.stages = Stages::kicks;
  pass.doc = "b turned into the spinning frame, with its Coriolis and centrifugal terms";
  pass.reads = {Column::reference_position, Column::body_force};
  pass.writes = {Column::body_force};
  pass.bind = [evaluation = setup.evaluation](State<2>& s) -> Kernel {
    const Frame spinning{0, s.setup.frame->spin};  // the angle is in the positions
    const auto own = fields_of_particles(s, {.motion = true}, evaluation);
    return [&s, spinning, own](const Instant& now) {
      own->set_time(now.t);
      see_body_force(spinning, *own, now.t, std::span(s.column(Column::body_force, 0), s.particles),
                     std::span(s.column(Column::body_force, 1), s.particles));
    };
  };
  return {pass};
}

}  // namespace

template <int Dim>
EffectRecord<Dim> moving_frame_effect() {
  EffectRecord<Dim> effect{30, "Coriolis and centrifugal terms of a frame that spins", "frame.spin"};
  effect.called_for = [](const Setup<Dim>& s) { return Dim == 2 && s.body_force && s.frame && s.frame->spin != 0; };
  if constexpr (Dim == 2) effect.passes = moving_frame_passes;
  return effect;
}

template EffectRecord<2> moving_frame_effect();
template EffectRecord<3> moving_frame_effect();

}  // namespace assay::mpm
