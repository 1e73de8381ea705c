// SPDX-License-Identifier: BSD-3-Clause
// The isochrone of a sheet, tau(xi) at one time: what it is cut into for the many points of a step.
#pragma once

#include <span>
#include <vector>

#include "harness/sheet/band.hpp"

namespace assay {

/// Chebyshev series on ranges of xi between kinks.
class Isochrone {
 public:
  struct Range {
    BandMap map;                       ///< xi <-> s
    Interval s{0, 1};                  ///< the part of the band that the series covers
    std::vector<int> active;           ///< components of tau that it has
    std::vector<double> coefficients;  ///< [k * active + c]
    std::size_t terms = 0;             ///< leading coefficients that matter
    double upper = 0;                  ///< where it ends, in factor * xi

    /// Drops what is rounding, notes the end.
    void trim();
  };

  /// Ranges ascending, without gaps. factor: the series is in factor * xi (g(t) where a sheet is a curve in eps).
  explicit Isochrone(std::vector<Range> ranges, double factor = 1);

  /// Nine components of tau and of d tau / d xi at xi [Pa].
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const;

  /// tau 11, 12, 21, 22 of n values of xi, of those from first to last - 1: tau[c * n + i] [Pa].
  void plane_tau(std::span<const double> xi, std::span<double> tau, std::size_t first, std::size_t last) const;

  /// Values of xi at which histories of two regimes meet, ascending. A border at which a band was divided is none.
  std::vector<double> kinks() const;

 private:
  const Range& range_of(double parameter) const;
  std::size_t neighbours_from(std::span<const double> xi, const Range& range, double* x) const;
  std::vector<Range> ranges_;
  double factor_;
};

}  // namespace assay
