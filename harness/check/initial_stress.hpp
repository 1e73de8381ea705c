// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// initial_state takes a stress, or refuses it; a step without deformation returns it, and it turns with the body.
TestResult initial_stress(const Specimen& specimen);

}  // namespace assay::check
