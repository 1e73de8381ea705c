// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A step that the model refuses is refused again, and leaves no trace in what it answers; and it is not the last
/// digits of F that decide what is refused.
TestResult refusals(const Specimen& specimen);

}  // namespace assay::check
