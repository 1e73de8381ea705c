// SPDX-License-Identifier: BSD-3-Clause
// What pictures of particles show: which shapes, and how much around them.
#pragma once

#include <vector>

#include "drivers/picture/value_pictures.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/problem.hpp"
#include "mpm/step/state.hpp"

namespace assay::drivers {

/// The particles of a body in the plane, as their domains are.
ParticleFrame plane_frame(const Problem& problem, const mpm::State<2>& state, double t);

/// What pictures show: the ring with a margin; of a body whose outside moves all of it, on all of its way [m].
Box plane_window(const PosedScene& problem);

/// Of bodies in space. What is drawn, as far as the body belongs there, with a margin: a particle that has got lost
/// does not make the body small. More of the width is for the axes of space.
void show_all(const std::vector<const ParticleFrame*>& frames, const Box& reach, ParticlePicture& picture);

}  // namespace assay::drivers
