// SPDX-License-Identifier: BSD-3-Clause
// Where in the ring of a vortex a value of xi is found.
#pragma once

#include <vector>

#include "harness/motion/kinds/vortex.hpp"

namespace assay {

/// Radii between which xi(R) is monotone, ascending, with ri and ro [m].
std::vector<double> turning_radii(const Vortex& vortex);

/// The inverse of xi(R) (13), which has several values.
class RadiiOfXi {
 public:
  explicit RadiiOfXi(const Vortex& vortex) : vortex_(vortex), turning_(turning_radii(vortex)) {}

  /// Every radius of the ring at which xi(R) goes through `xi`, ascending [m].
  std::vector<double> operator()(double xi) const;

 private:
  Vortex vortex_;
  std::vector<double> turning_;
};

}  // namespace assay
