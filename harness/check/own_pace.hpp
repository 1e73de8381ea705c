// SPDX-License-Identifier: BSD-3-Clause
// How long the steps may be in which a material that relaxes still answers as it does in short ones.
#pragma once

#include <optional>

#include "harness/check/battery.hpp"

namespace assay::check {

/// The longest step [s] of tests of a rate-dependent material that relaxes in much less time than their usual steps
/// take. Nothing where it does not: whatever is left in such steps is all that it has.
std::optional<double> own_pace(const Material& material, const Report& report);

}  // namespace assay::check
