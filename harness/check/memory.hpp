// SPDX-License-Identifier: BSD-3-Clause
// That the state is what a history has left in it.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A number of the state that no step reads, that is not zero at first and that departs from that value by what the
/// last step alone adds, is forgotten: nothing accumulates.
TestResult memory(const Specimen& specimen);

}  // namespace assay::check
