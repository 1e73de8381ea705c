// SPDX-License-Identifier: BSD-3-Clause
// Whether a motion is a stable solution for a model: strong ellipticity along its baseline path.
#pragma once

#include <array>
#include <functional>

#include "harness/material/material.hpp"
#include "harness/motion/path.hpp"

namespace assay {

struct StabilityScreen {
  enum class Verdict {
    stable,    ///< strongly elliptic along the whole path
    unstable,  ///< up to a first loss: the exact motion is not a stable solution
    neutral    ///< no resistance to some wave already at rest: a fluid; not judged any further
  };
  friend constexpr std::array<const char*, 3> names_of(Verdict) { return {"stable", "unstable", "neutral"}; }
  Verdict verdict = Verdict::stable;
  double smallest = 0;  ///< eigenvalue over the whole path, of a neutral material at rest; over the largest at rest [1]

  /// Places of the path that were not judged: the material fails in a step a little beyond them.
  int unjudged = 0;

  // The first loss, where unstable.
  double xi = 0, t = 0;              ///< [1], [s]
  Vector3 normal = Vector3::Zero();  ///< N of the wave that does not travel
  double safe_fraction = 1;  ///< of the range of xi within which nothing is lost, to 3 digits; NaN where xi is a place
};

/// Screens with A = dP/dF of the instantaneous loading branch, by differences of `update`, all xi of the path's range
/// and 0 <= t <= end [s]. Models that soften or do not keep the normal rule are followed to their first loss like any
/// other. `progress` is told the share of the times that are judged, in [0,1]; where a first loss is located it begins
/// anew. Throws MaterialFailure where the material fails at rest, along the path, or just beyond every place of it.
StabilityScreen screen_stability(const Material& material, const Path& path, double end,
                                 const std::function<void(double share)>& progress = {});

}  // namespace assay
