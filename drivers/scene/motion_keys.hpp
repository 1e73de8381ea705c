// SPDX-License-Identifier: BSD-3-Clause
// The part of the table of scene keys that says what moves and how: the motions' own keys, and what stands beside them.
#pragma once

#include <functional>

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// title, motion.* and frame.*, in the order in which they are read and written.
std::vector<Key> motion_keys();

/// The words of motion.type of all motions for which something holds.
std::vector<std::string> types_of(const std::function<bool(const Motion&)>& holds);

}  // namespace assay::drivers
