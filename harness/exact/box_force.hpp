// SPDX-License-Identifier: BSD-3-Clause
// The body force of the axis-aligned motion, b = a - DIV(P)/rho0, at reference points or on the mean over rectangles:
// of a cosine series both are exact.
#pragma once

#include <span>
#include <vector>

#include "harness/exact/box_stress.hpp"
#include "harness/exact/reference_domain.hpp"
#include "harness/numeric/cosine_rows.hpp"

namespace assay {

class BoxForce {
 public:
  /// places: of each particle [m]; points are rectangles of no area. density: rho0 [kg/m^3].
  BoxForce(const BoxStress& stress, double density, std::span<const Rectangle> places);

  /// Writes b [m/s^2] of each particle at the time that the stress is set to, which is t [s].
  void evaluate(const BoxStress& stress, double t, std::span<double> b_x, std::span<double> b_y);

 private:
  double density_;
  std::array<CosineRows, 2> rows_;           ///< along X and Y
  std::array<std::vector<double>, 2> sums_;  ///< of d P_dd / d X_d at each row, for each mode of the other axis [Pa/m]
};

}  // namespace assay
