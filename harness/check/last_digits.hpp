// SPDX-License-Identifier: BSD-3-Clause
// That equal calls give equal bits.
#pragma once

#include "harness/check/arrays.hpp"
#include "harness/check/call_steps.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

/// What the next call finds on its stack, where it reads before it writes.
void litter_stack(unsigned char byte);

/// A step that is taken again is the same to the last bit: from arrays at other addresses that are as far beyond a
/// multiple of 64 bytes, deeper in the stack, with other words left in memory by earlier calls, in the same place of an
/// equal batch, of other instances, in another process, and at the end of the battery. `repeated`: what calls.repeated
/// has found, of which it forgives the last digits.
TestResult last_digits(const Specimen& specimen, const std::vector<History>& first, const Difference& repeated);

}  // namespace assay::check
