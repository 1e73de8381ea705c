// SPDX-License-Identifier: BSD-3-Clause
// What a model offers besides its stress, against differences of it.
#pragma once

#include "harness/check/specimen.hpp"

namespace assay::check {

/// assay.tangent/1 against differences of `update` at deformed states, on and off the loading branch. One that does not
/// agree is compared with those of other conventions.
TestResult tangent(const Specimen& specimen);

/// assay.energy/1: P = dW/dF at fixed state.
TestResult energy(const Specimen& specimen);

/// The work done on the material is stored or dissipated, never made: along a path out, back and beyond.
TestResult dissipation(const Specimen& specimen);

}  // namespace assay::check
