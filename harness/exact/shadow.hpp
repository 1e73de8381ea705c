// SPDX-License-Identifier: BSD-3-Clause
// Shadow points: histories that are integrated alongside a run, at its own time levels.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "harness/history/troop.hpp"

namespace assay {

struct ShadowOptions {
  int radii = 400;          ///< histories, evenly over the path's xi
  double tolerance = 1e-8;  ///< of the histories, relative; not of the interpolation between them
  double end = 1;           ///< [s]
  Workers workers = {};
};

/// tau(xi) of one time after another, by cubics through neighbouring histories that took the same branches; over a
/// front between two histories by a straight line. Needs no table: any number of cycles, any kinks, at the price of an
/// interpolation error of the order of the distance between histories where there are fronts.
class Shadow {
 public:
  /// Keeps material and path.
  Shadow(std::shared_ptr<const Material> material, const Path& path, const ShadowOptions& options);

  /// To the time t, not before the one of the last call. Throws MaterialFailure.
  void advance(double t);
  double t() const { return t_; }

  /// tau and (d tau / d xi)_t at the present time [Pa].
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const;

  /// Middles of the intervals between histories that took different branches, ascending.
  std::vector<double> fronts() const;

  int radii() const { return static_cast<int>(xi_.size()); }
  /// Largest difference of tau between every second history and what the others make of it, so far, over the largest
  /// tau: a bound for the interpolation with all of them.
  double error() const { return scale_ > 0 ? difference_ / scale_ : 0; }
  std::int64_t calls() const;

 private:
  const std::vector<Branch>& branches(std::size_t i) const;
  bool alike(std::size_t i, std::size_t j) const;
  void interpolate(std::size_t first, std::size_t stride, double xi, Tensor& tau, Tensor& slope) const;
  void measure_error();

  std::shared_ptr<const Material> material_;
  Path path_;
  std::unique_ptr<Course> course_;
  Workers workers_;
  double t_ = 0;
  std::vector<double> xi_;
  std::vector<Troop> troops_;  ///< history i is number i / n of troop i % n
  std::vector<Tensor> tau_;
  double difference_ = 0, scale_ = 0;
};

}  // namespace assay
