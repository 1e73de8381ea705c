// SPDX-License-Identifier: BSD-3-Clause
// Which tractions act in a run.
#pragma once

#include <optional>

#include "drivers/scene/scene.hpp"
#include "mpm/setup/method.hpp"

namespace assay::drivers {

/// Throws InputError where the corners of a box are not corners of the particles' domains.
void require_surface(const Scene& scene);

/// On all faces of a body that the motion deforms and whose forces are computed; the form that keeps the exact motion
/// stable where the scene does not say, which is written into it.
std::optional<mpm::Traction> traction_of(Scene& scene);

}  // namespace assay::drivers
