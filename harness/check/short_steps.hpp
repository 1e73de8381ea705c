// SPDX-License-Identifier: BSD-3-Clause
// Whether a model takes steps so short that their strain looks like none.
#pragma once

#include <optional>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A failure of `step_halving` where a body that depends on the rate is held and bears another stress than one that
/// hardly moves, or where a loaded body answers to short strains with less than a hundredth of the stress
/// that longer ones make in proportion; nothing where it does not, or where its longer steps make none.
std::optional<TestResult> short_steps(const Specimen& specimen);

}  // namespace assay::check
