// SPDX-License-Identifier: BSD-3-Clause
// Values as colours: over two coordinates with lines on top, and of particles as the parallelograms that they occupy.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "drivers/picture/colormap.hpp"

namespace assay::drivers {

struct HeatMap {
  std::string title, x_label, y_label;
  std::string value_label;  ///< with its unit
  ColorMap map = ColorMap::diverging;
  std::array<double, 2> x{0, 1}, y{0, 1};  ///< ends of the axes; the cells divide them evenly
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;                     ///< [column * rows + row]; what is not finite is drawn grey
  std::vector<std::vector<Point>> lines, dashes;  ///< in the coordinates of the axes, drawn full and dashed
};

/// A PNG file, about 900 x 620 pixels. Throws std::invalid_argument where the number of values does not fit.
std::string png(const HeatMap& map);

/// One moment. Particle p is the parallelogram with the corners (x,y) ± r1 ± r2, so r1 and r2 are half edges [m]; or
/// a polygon, where there are any. All arrays have one length; a value that is not finite is drawn grey.
struct ParticleFrame {
  std::string caption;  ///< "t = 0.5 s"
  std::vector<double> x, y, r1x, r1y, r2x, r2y, value;
  std::vector<std::vector<Point>> polygons = {};  ///< in place of parallelograms, drawn in their order [m]
  std::vector<double> shade = {};                 ///< of each polygon, from 0, its colour, to 1, black; empty: 0

  std::size_t size() const { return polygons.empty() ? x.size() : polygons.size(); }
};

/// An axis of space, as a view of a body shows its unit vector: to the right and upwards.
struct SpaceAxis {
  std::string name;
  double right = 0, up = 0;
};

struct ParticlePicture {
  std::string title;
  std::string value_label;            ///< with its unit: "|u − u_{exact}| [m]"
  std::vector<ParticleFrame> frames;  ///< one large, several side by side with one colour bar
  ColorMap map = ColorMap::viridis;
  std::optional<std::array<double, 2>> range;  ///< of the colours; by default that of the values, around 0 if diverging
  std::vector<double> rings;                   ///< radii of circles around the origin drawn thin [m]
  std::string x_label = "x", y_label = "y";    ///< of the axes, without their unit; none: there are no axes
  std::array<double, 2> lower{-1.5, -1.5}, upper{1.5, 1.5};  ///< what is shown [m]
  std::string length_unit = "m";                             ///< of all lengths
  std::vector<SpaceAxis> space_axes;  ///< drawn in a corner, of a round length that is written beside them
};

/// One frame is about 900 pixels wide, three about 1500. At least one frame.
std::string png(const ParticlePicture& picture);

}  // namespace assay::drivers
