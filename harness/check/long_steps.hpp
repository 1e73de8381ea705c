// SPDX-License-Identifier: BSD-3-Clause
// Steps that are longer than the times in which a material relaxes.
#pragma once

#include <optional>
#include <string>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A part of `dissipation`: what relaxes bears no more in a long step than in a sudden one [s], and no more after a
/// long step in which it is held. Nothing where that holds, or where the material asks for shorter steps.
std::optional<TestResult> long_steps(const Specimen& specimen, double sudden);

/// What a body does in a long step in which it is held, one sentence: the relaxation of an explicit law overshoots in
/// a step that is longer than its time. Empty where it bears no more after it than before.
std::string overshoot(const Specimen& specimen);

}  // namespace assay::check
