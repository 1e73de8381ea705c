// SPDX-License-Identifier: BSD-3-Clause
// Why a material cannot be loaded at all.
#pragma once

#include <stdexcept>

#include "harness/check/battery.hpp"
#include "harness/material/material_failure.hpp"

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

}  // namespace assay::check
