// SPDX-License-Identifier: BSD-3-Clause
// What the length of the steps does to the result, and what the clock must not do.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// N, 2N, 4N, 8N steps along one path approach each other. Correct but first order in the step is no defect.
TestResult step_halving(const Specimen& specimen);

/// The result does not depend on the time of the day, nor that of a rate-independent model on the length of a step in
/// seconds: t from 0 and from 1e6 s, steps of 1e-9 to 1 s.
TestResult clock_independence(const Specimen& specimen);

}  // namespace assay::check
