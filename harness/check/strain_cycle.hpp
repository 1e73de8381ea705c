// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A material that has yielded is taken once around a cycle of strain within its elastic range: the most work that
/// comes out of it, over that of loading it once more. Nothing for what does not yield, or depends on the rate.
std::optional<double> out_of_a_cycle_after_yield(const Specimen& specimen);

}  // namespace assay::check
