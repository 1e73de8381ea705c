// SPDX-License-Identifier: BSD-3-Clause
// What must hold between the keys of a scene.
#pragma once

#include <functional>
#include <string>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// Throws InputError at `where(key)`.
void check_scene(const Scene& scene, const std::function<Location(const std::string& key)>& where);

}  // namespace assay::drivers
