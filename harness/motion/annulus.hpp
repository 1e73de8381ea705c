// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay {

/// Between two radii around the origin [m].
struct Annulus {
  double inner = 0, outer = 0;
  bool holds(double R) const { return R > inner && R < outer; }  ///< R: [m]
};

}  // namespace assay
