// SPDX-License-Identifier: BSD-3-Clause
// What must hold between the keys of a motion.
#pragma once

#include "drivers/scene/scene.hpp"
#include "drivers/scene/scene_check.hpp"

namespace assay::drivers {

/// Throws InputError at the key that does not go with the others.
void check_motion(const Scene& scene, const KeyPlace& where);

}  // namespace assay::drivers
