// SPDX-License-Identifier: BSD-3-Clause
// `run --junit FILE`: what a run has found, as a test suite for CI.
#pragma once

#include <string>

#include "drivers/findings/run_options.hpp"
#include "drivers/result/result.hpp"

namespace assay::drivers {

/// JUnit's XML: a test of the outcome, which takes `seconds`, and one for each expectation. The exit status is 0
/// exactly where no test fails. A run that was refused is an error.
std::string run_junit(const Result& result, const RunOptions& options, double seconds);

/// Throws InputError where the file would take the place of another that the run reads or writes.
void refuse_junit_in_the_way(const RunOptions& options);

}  // namespace assay::drivers
