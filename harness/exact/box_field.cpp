// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/box_field.hpp"

namespace assay {

namespace {

std::vector<Interval> points_on_axis(std::span<const double> X) {
  std::vector<Interval> points;
  for (const double x : X) points.push_back({x, x});
  return points;
}

}  // namespace

BoxField::BoxField(const BoxStress& stress, std::span<const double> X, std::span<const double> Y)
    : along_X_(stress.modes(0), points_on_axis(X)),
      along_Y_(stress.modes(1), points_on_axis(Y)),
      modes_Y_(static_cast<std::size_t>(stress.modes(1))) {
  for (auto& sums : sums_) sums.resize(along_X_.rows() * modes_Y_);
}

void BoxField::update(const BoxStress& stress) {
  for (std::size_t c = 0; c < sums_.size(); ++c) {
    for (std::size_t row = 0; row < along_X_.rows(); ++row) {
      stress.contract(c, 0, along_X_.mean(row), std::span(sums_[c]).subspan(row * modes_Y_, modes_Y_));
    }
  }
}

std::array<double, BoxStress::components> BoxField::at(std::size_t point) const {
  std::array<double, BoxStress::components> piola{};
  const std::span<const double> mode = along_Y_.mean(along_Y_.row_of(point));
  for (std::size_t c = 0; c < piola.size(); ++c) {
    piola[c] = sum_of_modes(mode, std::span(sums_[c]).subspan(along_X_.row_of(point) * modes_Y_, modes_Y_));
  }
  return piola;
}

}  // namespace assay
