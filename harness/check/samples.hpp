// SPDX-License-Identifier: BSD-3-Clause
// Steps in the middle of a history, at which what a model offers besides its stress is compared with differences.
#pragma once

#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

struct Sample {
  double t, dt;                ///< [s]
  Tensor F0, F1;               ///< [1]
  std::vector<double> state0;  ///< at the beginning
  Point end;                   ///< stress [Pa] and state
};

/// Of a history that turns while it is strained.
std::vector<Sample> samples_of(const Specimen& specimen);

/// The last steps of histories whose principal stretches are equal, two or three of them, to rounding and to the last
/// bit; the first is a step at rest. Those that the material refuses are left out.
std::vector<Sample> samples_at_equal_stretches(const Specimen& specimen);

}  // namespace assay::check
