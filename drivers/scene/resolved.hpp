// SPDX-License-Identifier: BSD-3-Clause
// resolved.yaml: a scene with every key and default written out.
#pragma once

#include <string>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// YAML text that reads back to the same scene; a function of the scene's values alone. Numbers are the shortest that
/// round-trip, paths are absolute.
std::string resolved_yaml(const Scene& scene);

}  // namespace assay::drivers
