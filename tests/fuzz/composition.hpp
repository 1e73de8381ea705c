// SPDX-License-Identifier: BSD-3-Clause
// What must hold of every scene that was read: it is composed, or refused in a line.
#pragma once

#include "drivers/scene/scene.hpp"

namespace assay::fuzz {

/// Assembles the scene's problem, composes its step and explains it, all in memory: no sheet, no file, no process, no
/// library. Scenes of other materials than the built-in ones are left out. Limits are lowered to these, so that larger
/// scenes are refused before particles or nodes are made.
inline constexpr double most_gib = 1.0 / 512;  ///< 131072 particles, 29127 nodes
inline constexpr double most_particle_steps = 1e9;

/// Throws InputError or MaterialFailure, std::logic_error where a promise is broken.
void compose_scene(drivers::Scene scene);

}  // namespace assay::fuzz
