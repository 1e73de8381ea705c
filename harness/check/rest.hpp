// SPDX-License-Identifier: BSD-3-Clause
// What must hold without any comparison: where nothing is deformed, or nothing more, nothing happens.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// F = I leaves no stress.
TestResult stress_at_rest(const Specimen& specimen);

/// Whether the stress at F = I is a pressure, the same in every frame.
bool pressed_at_rest(const Specimen& specimen);

/// Whether a stress comes up at F = I that depends on the time alone, not on the number of steps: growth, swelling, a
/// temperature of its own.
bool grows_at_rest(const Specimen& specimen);

/// sigma = sigma^T along the loading, which turns.
TestResult symmetry(const Specimen& specimen);

/// Steps with F1 = F0 after loading change neither stress nor state of a rate-independent model; of another one, in
/// the limit of no time.
TestResult zero_increment(const Specimen& specimen);

/// Name of a tensor or vector of the state that changes in steps without deformation, and in no time; empty where there
/// is none. No defect where the stress does not show it.
std::string drifting_variable(const Specimen& specimen);

}  // namespace assay::check
