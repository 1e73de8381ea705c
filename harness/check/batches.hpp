// SPDX-License-Identifier: BSD-3-Clause
// That a point's answer is its own: not that of its place in a batch, of the size of that, or of where arrays lie.
#pragma once

#include "harness/check/arrays.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

/// Steps in batches of many sizes, up to the largest, are those that are taken alone, but for rounding: the last points
/// of a batch are worked on by other code than those before. `alike`: what the first calls have found.
TestResult batches(const Specimen& specimen, const BatchFinding& alike);

/// Arrays that begin 8, 16, 32 bytes ... beyond a multiple of 64 give the same, but for rounding.
TestResult alignment(const Specimen& specimen);

}  // namespace assay::check
