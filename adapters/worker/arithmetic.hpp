// SPDX-License-Identifier: BSD-3-Clause
// The floating-point environment that a model is to leave as it found it.
#pragma once

#include <cstdint>

namespace assay::adapters {

/// Rounding to nearest, no traps, denormals kept.
void reset_arithmetic();

/// Or-ed Arithmetic: what differs from that.
std::uint32_t changes_of_arithmetic();

}  // namespace assay::adapters
