// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/panel.hpp"

#include <algorithm>
#include <cmath>

namespace assay::drivers {

namespace {

constexpr double bar_width = 24;

void outline(Canvas& canvas, double left, double top, double right, double bottom) {
  canvas.stroke(std::array<Point, 5>{{{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}}, 1,
                axis_color);
}

void mark(Canvas& canvas, Point from, Point to) { canvas.stroke(std::array<Point, 2>{from, to}, 1, axis_color); }

}  // namespace

double ColorBar::width() const {
  return bar_width + 12 + axis.widest_label(picture_text_size) + 20 + picture_text_size;
}

Color ColorBar::color_of(double value) const {
  return map_color(map, std::isfinite(value) ? (value - axis.low) / (axis.high - axis.low) : NAN);
}

void draw(Canvas& canvas, const ColorBar& bar) {
  const double left = bar.left, right = left + bar_width, top = bar.top, bottom = bar.bottom;
  for (double y = top; y < bottom; y += 0.5) {
    const std::array<Point, 4> strip{{{left, y}, {right, y}, {right, y + 0.5}, {left, y + 0.5}}};
    canvas.fill(strip, map_color(bar.map, (bottom - y) / (bottom - top)));
  }
  outline(canvas, left, top, right, bottom);
  for (std::size_t i = 0; i < bar.axis.major.size(); ++i) {
    const double y = bottom - (bottom - top) * bar.axis.fraction(bar.axis.major[i]);
    mark(canvas, {right, y}, {right + 6, y});
    canvas.text({right + 11, y + 6}, bar.axis.labels[i], {picture_text_size, ink, Anchor::left});
  }
  canvas.text({right + 11 + bar.axis.widest_label(picture_text_size) + 12 + picture_text_size, (top + bottom) / 2},
              bar.axis.titled(bar.label), {picture_text_size, ink, Anchor::middle, true});
}

std::array<double, 2> color_range(std::span<const double> values, ColorMap map) {
  Extent finite;
  for (const double value : values) {
    if (std::isfinite(value)) finite.add(value);
  }
  if (finite.empty()) return {0, 1};
  auto [low, high] = finite;
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

void draw(Canvas& canvas, const PanelAxes& axes) {
  const double left = axes.left, top = axes.top, right = axes.right, bottom = axes.bottom;
  for (std::size_t i = 0; i < axes.x.major.size(); ++i) {
    const double at = axes.at(axes.x.major[i], 0).x;
    mark(canvas, {at, bottom}, {at, bottom + 6});
    canvas.text({at, bottom + 25}, axes.x.labels[i], {picture_text_size, ink, Anchor::middle});
  }
  for (std::size_t i = 0; i < axes.y.major.size(); ++i) {
    const double at = axes.at(0, axes.y.major[i]).y;
    mark(canvas, {left - 6, at}, {left, at});
    if (axes.names_y) canvas.text({left - 11, at + 6}, axes.y.labels[i], {picture_text_size, ink, Anchor::right});
  }
  canvas.text({(left + right) / 2, bottom + axes.title_below}, axes.x_title, {picture_text_size, ink, Anchor::middle});
  if (axes.names_y) canvas.text({22, (top + bottom) / 2}, axes.y_title, {picture_text_size, ink, Anchor::middle, true});
  outline(canvas, left, top, right, bottom);
}

}  // namespace assay::drivers
