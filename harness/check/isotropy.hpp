// SPDX-License-Identifier: BSD-3-Clause
// A body that is turned once for all, with its frame or without.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Body and frame turned: F' = Q F Q^T.
TestResult change_of_basis(const Specimen& specimen);

/// The body alone turned before it is loaded: F' = F Q^T, sigma' = sigma for isotropic materials.
TestResult isotropy(const Specimen& specimen);

}  // namespace assay::check
