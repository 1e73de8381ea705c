// SPDX-License-Identifier: BSD-3-Clause
// What the tests have not seen of a material: a pass says nothing of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// As parts of a sentence: "strains above 0.01".
std::vector<std::string> not_tested(const Specimen& specimen);

/// A failed test of a material that does not stand the strain that was asked for, refuses the kink that it declares, or
/// calls a routine that is not there; nothing where there is none of these.
std::optional<TestResult> not_reached(const Specimen& specimen);

}  // namespace assay::check
