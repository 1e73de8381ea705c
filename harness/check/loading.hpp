// SPDX-License-Identifier: BSD-3-Clause
// Why a material cannot be loaded at all, how far it can, and what the tests have not seen of it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A failure of the material in a test: a finding with the step that fails. cause: where its twin stands the same; null
/// where it is that failure alone.
TestResult refused(const std::string& id, const char* cause, const MaterialFailure& failure);

/// Of a material that fails before any test can be made: what of its first steps it does not stand.
TestResult not_loaded(const Material& material, const std::runtime_error& error);

/// Of a material that answers in a straight line as far as it is finite.
TestResult not_finite_beyond(const MaterialFailure& failure);

/// Of a material that no small strain gives a stress.
TestResult without_stress(const Material& material);

/// A failed test of a material that does not stand the strain that was asked for, refuses the kink that it declares, or
/// calls a routine that is not there; nothing where there is none of these.
std::optional<TestResult> not_reached(const Specimen& specimen);

/// What a pass says nothing of, as parts of a sentence: "strains above 0.01".
std::vector<std::string> not_tested(const Specimen& specimen);

}  // namespace assay::check
