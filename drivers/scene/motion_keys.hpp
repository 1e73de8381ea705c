// SPDX-License-Identifier: BSD-3-Clause
// The part of the table of scene keys that says what moves and how.
#pragma once

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// Of motion.wave_speed: within these c and T = 1/c are both numbers of full precision [m/s].
inline constexpr double least_wave_speed = 1e-300, most_wave_speed = 1e300;

/// title, motion.* and frame.*, in the order in which they are read and written.
std::vector<Key> motion_keys();

}  // namespace assay::drivers
