// SPDX-License-Identifier: BSD-3-Clause
// The stress of the axis-aligned motion everywhere in its box. F depends on cos(pi X), cos(pi Y) and t alone, and so
// does P, which a Chebyshev series in both cosines is then a cosine series of:
//
//   P(X, Y, t) = sum_kl c_kl(t) cos(k pi X) cos(l pi Y)
//
// Its coefficients follow from the material at the series' nodes: one update each of a stress that is a function of F,
// else a history each, taken along in time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "harness/exact/exact_fields.hpp"
#include "harness/history/troop.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/numeric/chebyshev.hpp"
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

/// The coefficients at one time.
class BoxSeries {
 public:
  /// P11, P22, P33: the axes stay principal ones.
  static constexpr std::size_t components = 3;

  int modes(std::size_t d) const { return modes_[d]; }

  /// Adds up a component's coefficients over the modes of axis d, weighed: a number for each mode of the other axis.
  void contract(std::size_t component, std::size_t d, std::span<const double> weights, std::span<double> sums) const;

  /// P and its slopes along X and Y at a point [Pa], [Pa/m].
  struct Local {
    std::array<double, components> piola{}, along_X{}, along_Y{};
  };
  Local at(double X, double Y) const;

 private:
  friend class BoxStress;
  std::array<int, 2> modes_{};
  std::array<std::vector<double>, components> coefficients_;  ///< [k * modes(1) + l] of c_kl [Pa]
};

/// Takes the series along in time.
class BoxStress {
 public:
  /// Takes as many modes as the tolerance needs, or most_modes. Throws MaterialFailure.
  BoxStress(std::shared_ptr<const Material> material, const AxisAligned& motion, const BoxOptions& options);

  /// To the time of which the series is. Times must not descend, unless the stress is a function of F. Throws
  /// MaterialFailure.
  void set_time(double t);
  const BoxSeries& series() const { return series_; }

  /// What the last modes still hold, over the largest value: the largest since the first time.
  double error() const { return scale_ > 0 ? last_modes_ / scale_ : 0; }
  bool is_history() const { return !histories_.empty(); }
  std::int64_t material_calls() const;

  /// From rest, with the modes that were found.
  void begin_again();

 private:
  void lay_out(int modes, double end);
  void update_nodes(double t);
  void find_coefficients();
  void measure();

  std::shared_ptr<const Material> material_;
  AxisAligned motion_;
  BoxOptions options_;
  BoxSeries series_;
  std::vector<std::unique_ptr<Path>> sections_;  ///< of each node in Y
  std::vector<std::unique_ptr<Course>> courses_;
  std::vector<Troop> histories_;  ///< of each course, at the nodes in X, where the stress is no function of F
  std::vector<double> xi_, F0_, F1_, state_, after_, cauchy_;
  std::unique_ptr<chebyshev::GaussTransform> along_X_, along_Y_;
  double t_ = -1, last_modes_ = 0, scale_ = 0;
  std::int64_t calls_ = 0;
};

}  // namespace assay
