// SPDX-License-Identifier: BSD-3-Clause
// A material under a clock that goes at another pace: for models that take no step as long as those of the tests.
#pragma once

#include "harness/material/material.hpp"

namespace assay::check {

/// The same material, told `pace` times every time and every length of a step [1]. Its table lives as long as the
/// process, as those of the ABI do.
Material at_pace(const Material& material, double pace);

}  // namespace assay::check
