// SPDX-License-Identifier: BSD-3-Clause
// That `update` is a pure function of its arguments, and knows what is no number.
#pragma once

#include <map>
#include <string>

#include "harness/check/arrays.hpp"
#include "harness/check/call_steps.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

/// The same step again, after others, in another order, and of another instance, gives the same; so do the histories
/// that were the first of the process. `found`: the largest difference, however small.
TestResult repeated_calls(const Specimen& specimen, const std::vector<History>& first, Difference& found);

/// Each parameter a little larger, where its bounds allow that.
std::map<std::string, double> other_parameters(const Material& material);

/// A model that does not declare ASSAY_USES_INCREMENT does not read F0.
TestResult undeclared_increment(const Specimen& specimen);

/// F that is not a number, infinite, or turned inside out is refused or comes back as no number; nothing worse.
TestResult senseless_deformation(const Specimen& specimen);

}  // namespace assay::check
