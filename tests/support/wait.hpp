// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/numeric/stopwatch.hpp"

namespace assay {

/// Seconds within which work ends that waits for nobody. Sanitizers beside three other programs took 12 s for what
/// takes 1 s alone; a wait that should not be adds 20 s (the limit of a call in a worker), 120 s, or never ends.
inline constexpr double nobody_waited_s = 20;

}  // namespace assay
