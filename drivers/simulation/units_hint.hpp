// SPDX-License-Identifier: BSD-3-Clause
// Scenes that are written in mm, MPa and s and do not say so.
#pragma once

#include <string>

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// What to add to a scene in SI whose density is that of a solid in t/mm^3 and whose waves have the speed of those in a
/// solid in mm/s: a scene in mm, MPa and s gives itself away by both. Empty: it is nothing of the kind. To be told
/// where the run is refused for its many steps.
std::string units_hint(const PosedScene& problem);

/// The same before a run of very many steps.
std::string units_hint_for_many_steps(const PosedScene& problem);

}  // namespace assay::drivers
