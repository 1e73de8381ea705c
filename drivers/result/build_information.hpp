// SPDX-License-Identifier: BSD-3-Clause
// What this binary was built from, with what, and how.
#pragma once

#include "drivers/result/result.hpp"

namespace assay::drivers {

/// Version, `git describe` of the sources ("unknown" outside a checkout), compiler, its flags, versions of the
/// libraries; `scene_sha256` is left empty. Never fails.
Provenance build_information();

}  // namespace assay::drivers
