// SPDX-License-Identifier: BSD-3-Clause
// That the stress is a continuous function of the deformation.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A change of F in its last digits changes the stress no more than that.
TestResult continuity(const Specimen& specimen);

/// Along paths of single steps the stress jumps nowhere, unless the state does: a crack is remembered, a switch that
/// opens where the branches differ is not.
TestResult jumps(const Specimen& specimen);

}  // namespace assay::check
