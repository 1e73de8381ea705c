// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// The work done on the material is stored or dissipated, never made: against its energy along a path out, back and
/// beyond; and, of any model, from rest out and back no more comes out than was put in.
TestResult dissipation(const Specimen& specimen);

}  // namespace assay::check
