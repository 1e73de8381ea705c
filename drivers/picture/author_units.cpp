// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/author_units.hpp"

namespace assay::drivers {

namespace {

/// Renames the unit in brackets at the end of a label.
Scale rename(std::string& label, const Units& units) {
  const std::size_t open = label.rfind('[');
  if (open == label.npos || !label.ends_with(']')) return {};
  const std::string si = label.substr(open + 1, label.size() - open - 2);
  label = label.substr(0, open + 1) + units.name(si) + "]";
  return units.scale(si);
}

void convert(std::vector<double>& values, const Scale& scale) {
  for (double& value : values) value = scale.from_si(value);
}

void convert(std::array<double, 2>& ends, const Scale& scale) {
  for (double& value : ends) value = scale.from_si(value);
}

void convert(std::vector<std::vector<Point>>& lines, const Scale& x, const Scale& y) {
  for (auto& line : lines) {
    for (Point& at : line) at = {x.from_si(at.x), y.from_si(at.y)};
  }
}

}  // namespace

LinePlot in_units(LinePlot plot, const Units& units) {
  const Scale x = rename(plot.x_label, units), y = rename(plot.y_label, units);
  for (Series& series : plot.series) convert(series.x, x), convert(series.y, y);
  return plot;
}

HeatMap in_units(HeatMap map, const Units& units) {
  const Scale x = rename(map.x_label, units), y = rename(map.y_label, units);
  convert(map.x, x), convert(map.y, y);
  convert(map.lines, x, y), convert(map.dashes, x, y);
  convert(map.values, rename(map.value_label, units));
  return map;
}

ParticlePicture in_units(ParticlePicture picture, const Units& units) {
  const Scale length = units.scale(picture.length_unit), value = rename(picture.value_label, units);
  picture.length_unit = units.name(picture.length_unit);
  if (picture.range) convert(*picture.range, value);
  convert(picture.rings, length), convert(picture.lower, length), convert(picture.upper, length);
  for (ParticleFrame& frame : picture.frames) {
    for (auto* each : {&frame.x, &frame.y, &frame.r1x, &frame.r1y, &frame.r2x, &frame.r2y}) convert(*each, length);
    convert(frame.polygons, length, length);
    convert(frame.value, value);
  }
  return picture;
}

}  // namespace assay::drivers
