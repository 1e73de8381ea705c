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

/// Steps that no general history has: at rest; the last steps of histories whose principal stretches are equal, two or
/// three of them, to rounding and to the last bit; a step in which a loaded body is held. Those that the material
/// refuses are left out.
std::vector<Sample> samples_beside_histories(const Specimen& specimen);

}  // namespace assay::check
