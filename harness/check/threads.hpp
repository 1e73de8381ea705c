// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Two threads at once get what each gets alone: of one instance with ASSAY_THREAD_SAFE, each of its own without. A
/// race is met by chance: none that is short is sure to be found.
TestResult threads(const Specimen& specimen);

}  // namespace assay::check
