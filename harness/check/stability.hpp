// SPDX-License-Identifier: BSD-3-Clause
// How far a material stays strongly elliptic along the baselines: a property, and no defect.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// The smallest eigenvalue of the acoustic tensor, over the largest at rest, along simple shear (16) and uniaxial
/// strain (38); the sentence tells where it falls below zero. Never fails.
TestResult ellipticity(const Specimen& specimen);

}  // namespace assay::check
