// SPDX-License-Identifier: BSD-3-Clause
// What a model offers besides its stress, the differences that it is held against, and the steps in the middle of a
// history at which that is done.
#pragma once

#include <type_traits>
#include <vector>

#include "harness/check/specimen.hpp"
#include "harness/material/offer.hpp"

namespace assay::check {

/// A step and its end.
struct Sample : FailedStep {
  Point end;
};

/// Of a history that turns while it is strained.
std::vector<Sample> samples_of(const Specimen& specimen);

/// Steps that no general history has: at rest; the last steps of histories whose principal stretches are equal, two or
/// three of them, to rounding and to the last bit; a step in which a loaded body is held. Those that the material
/// refuses are left out.
std::vector<Sample> samples_beside_histories(const Specimen& specimen);

/// Stored energy [J/m^3]; no number where the model fails.
double stored_energy(const Offer<assay_energy>& form, const Tensor& F, const std::vector<double>& state);

/// d f / d x at 0, by central differences of fourth order.
template <class F>
std::invoke_result_t<F, double> slope_of(const F& f, double h) {
  return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

}  // namespace assay::check
