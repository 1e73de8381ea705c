// SPDX-License-Identifier: BSD-3-Clause
// Bands of xi in which the histories of a material take the same branches in the same order.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/history/history.hpp"

namespace assay {

/// A history's stretches between reversals and changes of regime.
struct Ray {
  std::vector<double> breaks;           ///< 0, ..., end [s]
  std::vector<std::uint64_t> branches;  ///< one a stretch: what makes two histories alike
};

/// Takes the history of xi and finds its breaks. Throws MaterialFailure.
Ray trace(const Course& course, double xi, const HistoryOptions& options, std::int64_t& calls);

/// xi = lower + width sigma(s), s in [0, 1]. Where a change of regime begins or ends to exist, at a grazing end, the
/// time of the change goes as the square root of the distance: there sigma is quadratic, and everything smooth in s.
struct BandMap {
  Interval xi;
  bool grazes_lower = false, grazes_upper = false;

  double xi_of(double s) const;
  double s_of(double xi) const;  ///< clamped to [0, 1]
  double slope(double s) const;  ///< d xi / d s
  bool is_linear() const { return !grazes_lower && !grazes_upper; }
};

struct Band {
  BandMap map;
  Ray ray;        ///< of one history inside: times differ from xi to xi, the order does not
  int parts = 1;  ///< into which a table divides every stretch of the ray
  std::size_t stretches() const { return ray.branches.size() * static_cast<std::size_t>(parts); }
};

/// Thrown where the regime of a history changes too often to be followed.
struct RegimesFlicker {};

/// Ascending, without gaps, over the path's parameter; xi = 0 parts two bands. `extra`: values of xi to look at besides
/// the usual ones. Throws MaterialFailure, RegimesFlicker.
std::vector<Band> find_bands(const Course& course, const HistoryOptions& options, std::vector<double> extra,
                             const Workers& workers, std::int64_t& calls);

}  // namespace assay
