// SPDX-License-Identifier: BSD-3-Clause
// What must hold without any comparison: where nothing is deformed, or nothing more, nothing happens.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// F = I leaves no stress.
TestResult stress_at_rest(const Specimen& specimen);

/// sigma = sigma^T along the loading, which turns.
TestResult symmetry(const Specimen& specimen);

/// A step with F1 = F0 after loading changes neither stress nor state of a rate-independent model.
TestResult zero_increment(const Specimen& specimen);

}  // namespace assay::check
