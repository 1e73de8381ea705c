// SPDX-License-Identifier: BSD-3-Clause
// What functions of extensions do to the arrays that they are given.
#pragma once

#include <string>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

/// A step of n points that are loaded alike, whose arrays begin `bytes` beyond a multiple of 64.
struct OfferedStep {
  std::size_t n;
  double dt;  ///< [s]
  Tensor before, after;
  std::vector<double> state0, state1, cauchy;  ///< component-major; the stress [Pa]
  std::size_t bytes;
};

/// What a function of an extension does wrong to its arrays at the end of that step, or empty.
std::string misdeed_of_offers(const Material& material, const OfferedStep& step);

}  // namespace assay::check
