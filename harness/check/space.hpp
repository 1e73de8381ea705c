// SPDX-License-Identifier: BSD-3-Clause
// Which deformations a material can be asked for, and those that the tests are made of.
#pragma once

#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

inline constexpr double turning_angle = 2.3;  ///< [rad], no fraction of a turn

/// All deformations, or those of the plane 12 alone (ASSAY_IN_PLANE), with a stretch 33.
class Space {
 public:
  explicit Space(const Material& material) : is_plane_(material.has(ASSAY_IN_PLANE)) {}

  bool is_plane() const { return is_plane_; }
  /// Whether the index 0..8 of a component (ABI) is of this space.
  bool has(int component) const;
  /// Without the components that are not of this space.
  Tensor within(const Tensor& A) const;
  /// By `angle` [rad] about (1, 2, 3): no component of a tensor keeps to itself; in the plane about its normal.
  Tensor turn(double angle) const;
  /// A stretch along turning axes, out, back and beyond: 0 <= s <= 1, F = I at 0.
  Tensor stretch(double amplitude, double s) const;

 private:
  bool is_plane_;
};

}  // namespace assay::check
