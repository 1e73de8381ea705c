// SPDX-License-Identifier: BSD-3-Clause
// What must hold between the keys of a scene.
#pragma once

#include <functional>
#include <string>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// Where a key of the scene stands.
using KeyPlace = std::function<Location(const std::string& key)>;

/// Throws InputError at the key.
[[noreturn]] void refuse_at(const KeyPlace& where, const std::string& key, const std::string& what);

/// Throws InputError at the key that does not go with the others.
void check_scene(const Scene& scene, const KeyPlace& where);

}  // namespace assay::drivers
