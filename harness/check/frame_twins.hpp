// SPDX-License-Identifier: BSD-3-Clause
// A history and its twin, which is to be the same turned.
#pragma once

#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "harness/check/shear_order.hpp"
#include "harness/check/specimen.hpp"

namespace assay::check {

inline constexpr double right_angle = std::numbers::pi / 2;

/// `seen` is to be `still`, turned by Q.
struct FrameTwins {
  const char* id;
  Loading still, seen;
  Tensor Q;
  Vector3 direction;
  std::string words;
};

/// Compares them at the steps of the specimen: `own_precision` is the most that it takes.
TestResult exact_twin(const Specimen& specimen, const FrameTwins& twins);

/// As `exact_twin`. An integrator that chooses its own steps by components of the strain takes others in another frame:
/// that error falls as steps become shorter than its own, and a defect's does not.
TestResult twin_or_tolerance(const Specimen& specimen, const FrameTwins& twins);

/// The order of shears by which the turns are right in which a history is: none of a law of the shear in one plane
/// alone, which is wrong in that plane, too. Of the orders that move all three one stands for both.
std::optional<ShearOrder> order_by_turns(const Specimen& specimen,
                                         const std::function<bool(const Tensor&, const Loading&)>& is_right);

/// 1 to 2, 2 to 3, 3 to 1.
Tensor next_axes();

}  // namespace assay::check
