// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/color_bar.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/picture/stroke_font.hpp"

namespace assay::drivers {

namespace {

constexpr double bar_width = 24;

double label_room(const ColorBar& bar) {
  double room = 0;
  for (const std::string& label : bar.axis.labels) room = std::max(room, label_width(label, bar.text_size));
  return room;
}

}  // namespace

double width_of(const ColorBar& bar) { return bar_width + 12 + label_room(bar) + 20 + bar.text_size; }

void draw(Canvas& canvas, const ColorBar& bar) {
  const double left = bar.left, right = left + bar_width, top = bar.top, bottom = bar.bottom;
  for (double y = top; y < bottom; y += 0.5) {
    const std::array<Point, 4> strip{{{left, y}, {right, y}, {right, y + 0.5}, {left, y + 0.5}}};
    canvas.fill(strip, map_color(bar.map, (bottom - y) / (bottom - top)));
  }
  canvas.stroke(std::array<Point, 5>{{{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}}, 1,
                axis_color);
  for (std::size_t i = 0; i < bar.axis.major.size(); ++i) {
    const double y = bottom - (bottom - top) * bar.axis.fraction(bar.axis.major[i]);
    canvas.stroke(std::array<Point, 2>{{{right, y}, {right + 6, y}}}, 1, axis_color);
    canvas.text({right + 11, y + 6}, bar.axis.labels[i], {bar.text_size, ink, Anchor::left});
  }
  const std::string label = bar.label + (bar.axis.factor.empty() ? "" : "  (" + bar.axis.factor + ")");
  canvas.text({right + 11 + label_room(bar) + 12 + bar.text_size, (top + bottom) / 2}, label,
              {bar.text_size, ink, Anchor::middle, true});
}

std::array<double, 2> color_range(std::span<const double> values, ColorMap map) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high)) return {0, 1};
  if (map == ColorMap::diverging) {
    high = std::max(std::abs(low), std::abs(high));
    if (high == 0) high = 1;
    low = -high;
  } else if (low > 0 && low < 0.3 * high) {
    low = 0;
  }
  if (!(high > low)) high = low + (low == 0 ? 1 : std::abs(low));
  return {low, high};
}

}  // namespace assay::drivers
