// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/heat_map.hpp"

#include <cmath>
#include <stdexcept>

#include "drivers/picture/color_bar.hpp"
#include "drivers/picture/stroke_font.hpp"
#include "drivers/picture/ticks.hpp"

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

void draw_cells(Canvas& canvas, const Panel& panel, const std::array<double, 2>& range) {
  const HeatMap& map = panel.map;
  const double width = panel_width / static_cast<double>(map.columns), height = panel_height / double(map.rows);
  for (std::size_t i = 0; i < map.columns; ++i) {
    const double left = panel.left + static_cast<double>(i) * width;
    for (std::size_t j = 0; j < map.rows; ++j) {
      const double value = map.values[i * map.rows + j], low = panel.bottom() - static_cast<double>(j) * height;
      const double s = (value - range[0]) / (range[1] - range[0]);
      const std::array<Point, 4> cell{
          {{left, low}, {left + width, low}, {left + width, low - height}, {left, low - height}}};
      canvas.fill(cell, map_color(map.map, std::isfinite(value) ? s : NAN));
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

void draw_axes(Canvas& canvas, const Panel& panel, const Axis& x, const Axis& y) {
  const double left = panel.left, right = panel.right(), bottom = panel.bottom();
  for (std::size_t i = 0; i < x.major.size(); ++i) {
    const double at = left + panel_width * x.fraction(x.major[i]);
    canvas.stroke(std::array<Point, 2>{{{at, bottom}, {at, bottom + 6}}}, 1, axis_color);
    canvas.text({at, bottom + 25}, x.labels[i], {picture_text_size, ink, Anchor::middle});
  }
  for (std::size_t i = 0; i < y.major.size(); ++i) {
    const double at = bottom - panel_height * y.fraction(y.major[i]);
    canvas.stroke(std::array<Point, 2>{{{left - 6, at}, {left, at}}}, 1, axis_color);
    canvas.text({left - 11, at + 6}, y.labels[i], {picture_text_size, ink, Anchor::right});
  }
  const auto with_factor = [](const std::string& label, const Axis& axis) {
    return label + (axis.factor.empty() ? "" : "  (" + axis.factor + ")");
  };
  canvas.text({(left + right) / 2, bottom + 52}, with_factor(panel.map.x_label, x),
              {picture_text_size, ink, Anchor::middle});
  canvas.text({22, (top + bottom) / 2}, with_factor(panel.map.y_label, y),
              {picture_text_size, ink, Anchor::middle, true});
  canvas.stroke(std::array<Point, 5>{{{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}}, 1,
                axis_color);
}

}  // namespace

std::string png(const HeatMap& map) {
  if (map.columns == 0 || map.rows == 0 || map.values.size() != map.columns * map.rows) {
    throw std::invalid_argument("HeatMap: values do not fit rows and columns");
  }
  const std::array<double, 2> range = color_range(map.values, map.map);
  const Axis x = make_axis(map.x[0], map.x[1], false, Fit::tight, 7);
  const Axis y = make_axis(map.y[0], map.y[1], false, Fit::tight, 6);
  double widest = 0;
  for (const std::string& label : y.labels) widest = std::max(widest, label_width(label, picture_text_size));
  const Panel panel{map, 44 + widest};
  const ColorBar bar{map.map,
                     make_axis(range[0], range[1], false, Fit::tight, 8),
                     map.value_label,
                     panel.right() + 28,
                     top,
                     panel.bottom(),
                     picture_text_size};
  Canvas canvas(static_cast<int>(std::ceil(bar.left + width_of(bar))), static_cast<int>(panel.bottom() + 70), paper);
  canvas.text({panel.left, 34}, map.title, {picture_text_size * 1.2, ink, Anchor::left});
  canvas.clip(panel.left, top, panel.right(), panel.bottom());
  draw_cells(canvas, panel, range);
  draw_lines(canvas, panel);
  canvas.unclip();
  draw_axes(canvas, panel, x, y);
  draw(canvas, bar);
  return canvas.png();
}

}  // namespace assay::drivers
