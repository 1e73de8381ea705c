// SPDX-License-Identifier: BSD-3-Clause
// Whether a body at rest resists whatever small strain it is brought to.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// The smallest eigenvalue of the stiffness at rest, where that is linear, over its largest component: below zero a
/// strain makes a stress that drives it on. None is right of a fluid in shear. Of what depends on the rate the
/// stiffness that is left in the end counts as well.
TestResult positive_stiffness(const Specimen& specimen);

}  // namespace assay::check
