// SPDX-License-Identifier: BSD-3-Clause
// Why a body is without particles.
#include <algorithm>
#include <cmath>

#include "drivers/simulation/warnings.hpp"

namespace assay::drivers {

std::string no_particle_sentence(const PosedScene& problem) {
  const double spacing = problem.scene.grid->spacing;
  double far = 0;
  for (const auto& corner : {problem.scene.body.lower, problem.scene.body.upper}) {
    for (std::size_t d = 0; d < corner.size(); ++d) far = std::max(far, std::abs(corner[d]));
  }
  const double apart = std::nextafter(far, 2 * far) - far;
  std::string sentence = "leaves no particle in the body";
  if (apart < 1e-6 * spacing) return sentence;
  const Units& units = problem.scene.units;
  return sentence + ": " + units.text(far, "m", 2) + " from the origin, coordinates are rounded to " +
         units.text(apart, "m", 2) + "; place the body nearer to it";
}

}  // namespace assay::drivers
