// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/heat_map.hpp"

#include <cmath>
#include <stdexcept>

#include "drivers/picture/panel.hpp"

namespace assay::drivers {

namespace {

constexpr double panel_width = 700, panel_height = 480, top = 56;

struct Panel {
  const HeatMap& map;
  double left;
  double right() const { return left + panel_width; }
  double bottom() const { return top + panel_height; }
  Point at(double x, double y) const {
    return {left + panel_width * (x - map.x[0]) / (map.x[1] - map.x[0]),
            bottom() - panel_height * (y - map.y[0]) / (map.y[1] - map.y[0])};
  }
};

void draw_cells(Canvas& canvas, const Panel& panel, const ColorBar& bar) {
  const HeatMap& map = panel.map;
  const double width = panel_width / static_cast<double>(map.columns), height = panel_height / double(map.rows);
  for (std::size_t i = 0; i < map.columns; ++i) {
    const double left = panel.left + static_cast<double>(i) * width;
    for (std::size_t j = 0; j < map.rows; ++j) {
      const double low = panel.bottom() - static_cast<double>(j) * height;
      const std::array<Point, 4> cell{
          {{left, low}, {left + width, low}, {left + width, low - height}, {left, low - height}}};
      canvas.fill(cell, bar.color_of(map.values[i * map.rows + j]));
    }
  }
}

void draw_lines(Canvas& canvas, const Panel& panel) {
  const auto placed = [&](const std::vector<Point>& line) {
    std::vector<Point> out;
    for (const Point p : line) out.push_back(panel.at(p.x, p.y));
    return out;
  };
  for (const auto& line : panel.map.dashes) canvas.stroke(placed(line), 1, axis_color, 6);
  for (const auto& line : panel.map.lines) canvas.stroke(placed(line), 1.8, ink);
}

}  // namespace

std::string png(const HeatMap& map) {
  if (map.columns == 0 || map.rows == 0 || map.values.size() != map.columns * map.rows) {
    throw std::invalid_argument("HeatMap: values do not fit rows and columns");
  }
  const std::array<double, 2> range = color_range(map.values, map.map);
  const Axis x = make_axis(map.x[0], map.x[1], false, Fit::tight, 7);
  const Axis y = make_axis(map.y[0], map.y[1], false, Fit::tight, 6);
  const Panel panel{map, 44 + y.widest_label(picture_text_size)};
  const double left = panel.left, right = panel.right(), bottom = panel.bottom();
  const ColorBar bar{map.map, make_axis(range[0], range[1], false, Fit::tight, 8), map.value_label, right + 28, top,
                     bottom};
  Canvas canvas(static_cast<int>(std::ceil(bar.left + bar.width())), static_cast<int>(bottom + 70), paper);
  canvas.text({left, 34}, map.title, {picture_text_size * 1.2, ink, Anchor::left});
  canvas.clip(left, top, right, bottom);
  draw_cells(canvas, panel, bar);
  draw_lines(canvas, panel);
  canvas.unclip();
  const auto at = [&](double u, double v) {
    return Point{left + panel_width * x.fraction(u), bottom - panel_height * y.fraction(v)};
  };
  draw(canvas, PanelAxes{left, top, right, bottom, x, y, x.titled(map.x_label), y.titled(map.y_label), 52, at, true});
  draw(canvas, bar);
  return canvas.png();
}

}  // namespace assay::drivers
