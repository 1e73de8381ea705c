// SPDX-License-Identifier: BSD-3-Clause
// How long the steps may be in which a material that relaxes still answers as it does in short ones; and the material
// under a clock at that pace.
#pragma once

#include <optional>

#include "harness/check/battery.hpp"

namespace assay::check {

/// The longest step [s] of tests of a rate-dependent material that relaxes in much less time than their usual steps
/// take. Nothing where it does not: whatever is left in such steps is all that it has.
std::optional<double> own_pace(const Material& material, const Report& report);

/// The same material, told `pace` times every time and every length of a step [1]. Its table lives as long as the
/// process, as those of the ABI do.
Material at_pace(const Material& material, double pace);

}  // namespace assay::check
