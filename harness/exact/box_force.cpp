// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/box_force.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"

#include <array>

namespace assay {

namespace {

std::vector<Interval> sides(std::span<const Rectangle> places, std::size_t d) {
  std::vector<Interval> all;
  for (const Rectangle& place : places) all.push_back({place.lower[d], place.upper[d]});
  return all;
}

}  // namespace

BoxForce::BoxForce(const BoxStress& stress, double density, std::span<const Rectangle> places)
    : density_(density),
      rows_{CosineRows(stress.modes(0), sides(places, 0)), CosineRows(stress.modes(1), sides(places, 1))} {
  for (std::size_t d = 0; d < 2; ++d) {
    sums_[d].resize(rows_[d].rows() * static_cast<std::size_t>(stress.modes(1 - d)));
  }
}

void BoxForce::evaluate(const BoxStress& stress, double t, std::span<double> b_x, std::span<double> b_y) {
  const AxisAligned& motion = stress.motion();
  const double g = motion.amplitude.at(t).acceleration;  // of u_x where sin(pi X) = 1 [m/s^2]
  const double inertia[] = {g, motion.one_dimensional ? 0 : -g};
  const std::array<std::span<double>, 2> b{b_x, b_y};
  for (std::size_t d = 0; d < 2; ++d) {
    const auto others = static_cast<std::size_t>(stress.modes(1 - d));
    const auto sums = [&](std::size_t row) { return std::span(sums_[d]).subspan(row * others, others); };
    for (std::size_t row = 0; row < rows_[d].rows(); ++row) stress.contract(d, d, rows_[d].slope(row), sums(row));
    for (std::size_t p = 0; p < b[d].size(); ++p) {
      const std::uint32_t row = rows_[d].row_of(p), across = rows_[1 - d].row_of(p);
      const double divergence = sum_of_modes(rows_[1 - d].mean(across), sums(row));
      b[d][p] = inertia[d] * rows_[d].mean_sine(row) - divergence / density_;  // d P_dd / d X_d, [m/s^2]
    }
  }
}

}  // namespace assay
