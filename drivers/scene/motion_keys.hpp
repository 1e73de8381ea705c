// SPDX-License-Identifier: BSD-3-Clause
// The part of the table of scene keys that says what moves and how.
#pragma once

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// title, motion.* and frame.*, in the order in which they are read and written.
std::vector<Key> motion_keys();

}  // namespace assay::drivers
