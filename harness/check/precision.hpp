// SPDX-License-Identifier: BSD-3-Clause
// To how many digits a material computes its stress.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Whether the stress follows F, or the length of a step, as numbers of 24 bits do: in steps of 6e-8.
bool is_of_single_precision(const Specimen& specimen);

}  // namespace assay::check
