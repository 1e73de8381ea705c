// SPDX-License-Identifier: BSD-3-Clause
// As what a step reads the tensors of a state that was turned.
#pragma once

#include "harness/check/march.hpp"
#include "harness/check/specimen.hpp"
#include "harness/check/turned_step.hpp"

namespace assay::check {

/// A loaded point, and the lengths of its steps [s].
struct Loaded {
  Tensor F;
  Point point;
  double length, instant;
};

/// Fills in the error of a loading step from a turned state, `stress` and `taken`: the least unlikely assumptions that
/// explain it. The step goes on from place s of the loading.
void read_back(const Specimen& specimen, const Loaded& from, double s, TurnedStep& found);

}  // namespace assay::check
