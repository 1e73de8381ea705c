// SPDX-License-Identifier: BSD-3-Clause
// P of the axis-aligned motion at fixed reference points, for many of them at once.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "harness/exact/box_stress.hpp"
#include "harness/numeric/cosine_rows.hpp"

namespace assay {

class BoxField {
 public:
  /// X, Y: reference positions [m].
  BoxField(const BoxStress& stress, std::span<const double> X, std::span<const double> Y);

  /// To the time of the stress.
  void update(const BoxStress& stress);

  /// P11, P22, P33 at a point [Pa].
  std::array<double, BoxStress::components> at(std::size_t point) const;

 private:
  CosineRows along_X_, along_Y_;
  std::size_t modes_Y_;
  std::array<std::vector<double>, BoxStress::components> sums_;  ///< over the modes in X, at each distinct X
};

}  // namespace assay
