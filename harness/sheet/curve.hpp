// SPDX-License-Identifier: BSD-3-Clause
// tau(eps) of a material whose stress is a function of F alone, on a straight family of paths.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "harness/sheet/isochrone.hpp"

namespace assay {

/// Chebyshev in eps = xi g(t).
class Curve {
 public:
  /// n nodes over every eps that the path reaches until `end`. Throws MaterialFailure.
  Curve(const Material& material, const Path& path, double end, int n);

  Isochrone isochrone(double t) const;
  Isochrone in_eps() const { return Isochrone({range_}); }  ///< tau and d tau / d eps
  int nodes() const { return nodes_; }
  Interval eps() const { return range_.map.xi; }
  double left_out() const { return left_out_; }  ///< by the series, as its last terms tell [Pa]

 private:
  std::function<double(double)> amplitude_;
  Isochrone::Range range_;
  int nodes_ = 0;
  double left_out_ = 0;
};

/// tau of one step from rest to each eps, 9 * n [Pa].
std::vector<double> tau_of_eps(const Material& material, const Path& loading, std::span<const double> eps);

}  // namespace assay
