// SPDX-License-Identifier: BSD-3-Clause
// That a material keeps to its arrays.
#pragma once

#include <array>

#include "harness/check/battery.hpp"

namespace assay::check {

/// Stress and state of one point after each step of a loading.
using History = std::vector<std::vector<double>>;

/// Along loadings, in batches of several sizes: nothing is written beyond the arrays, nor into what is given, and every
/// component of the results is written. To be taken first: other tests trust the arrays. `first`: what the very first
/// calls of the process give, for amplitudes_of_first.
TestResult guarded_arrays(const Material& material, const Options& options, std::vector<History>& first);

/// From small to large, none beyond the strain that was asked for.
std::array<double, 4> amplitudes_of_first(const Effort& effort);

/// One of these again.
History history(const Material& material, double amplitude);

}  // namespace assay::check
