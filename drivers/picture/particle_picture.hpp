// SPDX-License-Identifier: BSD-3-Clause
// Particles as the parallelograms that they occupy, coloured by one value.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/picture/colormap.hpp"

namespace assay::drivers {

/// One moment. Particle p is the parallelogram with the corners (x,y) ± r1 ± r2, so r1 and r2 are half edges [m].
/// All arrays have one length; a value that is not finite is drawn grey.
struct ParticleFrame {
  std::string caption;  ///< "t = 0.5 s"
  std::vector<double> x, y, r1x, r1y, r2x, r2y, value;
};

struct ParticlePicture {
  std::string title;
  std::string value_label;            ///< with its unit: "|u − u_{exact}| [m]"
  std::vector<ParticleFrame> frames;  ///< one large, several side by side with one colour bar
  ColorMap map = ColorMap::viridis;
  std::optional<std::array<double, 2>> range;  ///< of the colours; by default that of the values, around 0 if diverging
  std::vector<double> rings;                   ///< radii of circles around the origin drawn thin [m]
  std::array<double, 2> lower{-1.5, -1.5}, upper{1.5, 1.5};  ///< what is shown [m]
};

/// One frame is about 900 pixels wide, three about 1500. At least one frame.
std::string png(const ParticlePicture& picture);

}  // namespace assay::drivers
