// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay::drivers {

/// How much a verb says on standard error.
enum class Verbosity { quiet, normal, verbose };

}  // namespace assay::drivers
