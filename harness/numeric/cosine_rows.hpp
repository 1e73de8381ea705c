// SPDX-License-Identifier: BSD-3-Clause
// What the modes cos(k pi X) of a cosine series have at points of an axis, and on the mean over stretches of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/numeric/range.hpp"

namespace assay {

/// A row of all modes for each distinct stretch [m]; a point is a stretch of no width.
class CosineRows {
 public:
  CosineRows(int modes, std::span<const Interval> stretches);

  std::size_t rows() const { return mean_sine_.size(); }
  /// Of the stretch that was given as the p-th.
  std::uint32_t row_of(std::size_t p) const { return row_[p]; }

  /// Means of cos(k pi X) over the stretch of a row [1].
  std::span<const double> mean(std::size_t row) const { return modes_of(mean_, row); }
  /// Means of its slope, -k pi sin(k pi X) [1/m].
  std::span<const double> slope(std::size_t row) const { return modes_of(slope_, row); }
  /// Mean of sin(pi X) [1].
  double mean_sine(std::size_t row) const { return mean_sine_[row]; }

 private:
  std::span<const double> modes_of(const std::vector<double>& all, std::size_t row) const {
    return {all.data() + row * modes_, modes_};
  }
  std::size_t modes_;
  std::vector<std::uint32_t> row_;
  std::vector<double> mean_, slope_, mean_sine_;
};

/// Weighed, of so many modes.
inline double sum_of_modes(std::span<const double> weights, std::span<const double> modes) {
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * modes[k];
  return sum;
}

}  // namespace assay
