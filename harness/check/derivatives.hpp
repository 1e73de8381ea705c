// SPDX-License-Identifier: BSD-3-Clause
// What a model offers besides its stress, against differences of it.
#pragma once

#include "harness/check/specimen.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

/// assay.tangent/1 against differences of `update` at deformed states, on and off the loading branch. One that does not
/// agree is compared with those of other conventions.
TestResult tangent(const Specimen& specimen);

/// How the sentence begins of one whose largest components agree, but not what a change of shape adds.
inline constexpr const char* tangent_of_shape = "the tangent of a change of shape";

/// What a sentence holds of a tangent of which no more can be told than how wrong it is.
inline constexpr const char* of_largest_component = " of its largest component; ";

/// assay.energy/1: P = dW/dF at fixed state.
TestResult energy(const Specimen& specimen);

/// Stored energy [J/m^3]; no number where the model fails.
double stored_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state);

}  // namespace assay::check
