// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/value_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "drivers/picture/panel.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr double panel_width = 700, panel_height = 480, panel_top = 56;  ///< of a heat map [pixel]

void draw_cells(Canvas& canvas, const HeatMap& map, const PlotFrame& panel, const ColorBar& bar) {
  const double width = panel_width / static_cast<double>(map.columns), height = panel_height / double(map.rows);
  for (std::size_t i = 0; i < map.columns; ++i) {
    const double left = panel.left + static_cast<double>(i) * width;
    for (std::size_t j = 0; j < map.rows; ++j) {
      const double low = panel.bottom - static_cast<double>(j) * height;
      const std::array<Point, 4> cell{
          {{left, low}, {left + width, low}, {left + width, low - height}, {left, low - height}}};
      canvas.fill(cell, bar.color_of(map.values[i * map.rows + j]));
    }
  }
}

void draw_lines(Canvas& canvas, const HeatMap& map, const PlotFrame& panel) {
  const auto placed = [&](const std::vector<Point>& line) {
    return mapped(line, [&](Point p) { return panel.at(p.x, p.y); });
  };
  for (const auto& line : map.dashes) canvas.stroke(placed(line), 1, axis_color, 6);
  for (const auto& line : map.lines) canvas.stroke(placed(line), 1.8, ink);
}

struct Layout {
  double panel_width = 0, panel_height = 0, left = 0, top = 0, gap = 0;
  double bar_left = 0, width = 0, height = 0;
};

Layout lay_out(const ParticlePicture& picture, const ColorBar& bar) {
  Layout out;
  const double count = static_cast<double>(picture.frames.size());
  const double aspect = (picture.upper[1] - picture.lower[1]) / (picture.upper[0] - picture.lower[0]);
  out.panel_width = picture.frames.size() == 1 ? 700 : std::max(240.0, (1330 - 26 * (count - 1)) / count);
  out.panel_height = std::clamp(out.panel_width * aspect, 60.0, 1600.0);
  out.left = 78;
  out.gap = 26;
  const bool captions = std::any_of(picture.frames.begin(), picture.frames.end(),
                                    [](const ParticleFrame& frame) { return !frame.caption.empty(); });
  out.top = 18 + (picture.title.empty() ? 0 : 32) + (captions ? 28 : 0);
  out.bar_left = out.left + count * out.panel_width + (count - 1) * out.gap + 28;
  out.width = out.bar_left + bar.width();
  out.height = out.top + out.panel_height + 66;
  return out;
}

std::array<double, 2> color_range(const ParticlePicture& picture) {
  if (picture.range) return *picture.range;
  std::vector<double> values;
  for (const ParticleFrame& frame : picture.frames) values.insert(values.end(), frame.value.begin(), frame.value.end());
  return color_range(values, picture.map);
}

/// One panel's map from metres to pixels.
struct View {
  const ParticlePicture& picture;
  double left, top, scale, bottom;
  Point at(double x, double y) const {
    return {left + (x - picture.lower[0]) * scale, bottom - (y - picture.lower[1]) * scale};
  }
};

/// What one particle looks like on the picture.
struct Shape {
  std::vector<Point> corners;      ///< closed
  double area = 0, thickness = 0;  ///< [pixel^2], [pixel]
};

Shape shape_of_polygon(const View& view, const std::vector<Point>& polygon) {
  Shape out;
  double longest = 0;
  for (const Point& corner : polygon) out.corners.push_back(view.at(corner.x, corner.y));
  out.corners.push_back(out.corners.front());
  for (std::size_t k = 0; k + 1 < out.corners.size(); ++k) {
    const Point &a = out.corners[k], &b = out.corners[k + 1];
    out.area += 0.5 * (a.x * b.y - a.y * b.x);
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  }
  out.area = std::abs(out.area);
  out.thickness = longest > 0 ? out.area / longest : 0;
  return out;
}

Shape shape_of(const View& view, const ParticleFrame& frame, std::size_t p) {
  if (!frame.polygons.empty()) return shape_of_polygon(view, frame.polygons[p]);
  const auto corner = [&](double s1, double s2) {
    return view.at(frame.x[p] + s1 * frame.r1x[p] + s2 * frame.r2x[p],
                   frame.y[p] + s1 * frame.r1y[p] + s2 * frame.r2y[p]);
  };
  Shape out{{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)}};
  const double scale = view.scale;
  const double longest = std::max(std::hypot(frame.r1x[p], frame.r1y[p]), std::hypot(frame.r2x[p], frame.r2y[p]));
  out.area = 4 * std::abs(frame.r1x[p] * frame.r2y[p] - frame.r1y[p] * frame.r2x[p]) * scale * scale;
  out.thickness = longest > 0 ? out.area / (2 * longest * scale) : 0;
  return out;
}

/// Outlines show the shapes where there is room for them.
bool has_room(const Shape& shape) { return shape.area > 81 && shape.thickness > 5; }

/// Whether most polygons have room: on a cut some are as large as a domain and others slivers, and lines around some of
/// them would look like a property of the body.
bool most_have_room(const View& view, const ParticleFrame& frame) {
  std::size_t with_room = 0;
  for (std::size_t p = 0; p < frame.size(); ++p) with_room += has_room(shape_of(view, frame, p));
  return 2 * with_room > frame.size();
}

void draw_particles(Canvas& canvas, const View& view, const ParticleFrame& frame, const ColorBar& bar) {
  const auto color = [&](std::size_t p) {
    const Color own = bar.color_of(frame.value[p]);
    return frame.shade.empty() ? own : mix(own, rgb(0), frame.shade[p]);
  };
  const auto bleed = [&](std::size_t p, const Shape& shape) {
    canvas.stroke(shape.corners, std::clamp(0.35 * std::sqrt(shape.area), 0.8, 2.5), color(p));
  };
  const bool in_order = !frame.shade.empty();  // what is nearer hides what is behind it
  const bool is_outlined = frame.polygons.empty() || most_have_room(view, frame);
  // Sheared parallelograms do not tile: a little bleeding under all of them closes the cracks.
  for (std::size_t p = 0; !in_order && p < frame.size(); ++p) bleed(p, shape_of(view, frame, p));
  for (std::size_t p = 0; p < frame.size(); ++p) {
    const Shape shape = shape_of(view, frame, p);
    if (in_order) bleed(p, shape);
    canvas.fill(std::span(shape.corners).first(shape.corners.size() - 1), color(p));
    if (is_outlined && has_room(shape)) canvas.stroke(shape.corners, 0.6, mix(color(p), paper, 0.4));
  }
}

void draw_rings(Canvas& canvas, const View& view) {
  for (const double radius : view.picture.rings) {
    std::vector<Point> circle;
    for (int i = 0; i <= 360; ++i) {
      const double angle = i * std::numbers::pi / 180;
      circle.push_back(view.at(radius * std::cos(angle), radius * std::sin(angle)));
    }
    canvas.stroke(circle, 1, ink);
  }
}

/// The largest of 1, 2, 5, 10, 20, ... that is not larger.
double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
}

void draw_space_axes(Canvas& canvas, const View& view) {
  const auto& axes = view.picture.space_axes;
  if (axes.empty()) return;
  constexpr double part = 0.12, gap = 14, head = 7, from_left = 28, from_bottom = 20;  // of the width; [pixel]
  const double length = round_length(part * (view.picture.upper[0] - view.picture.lower[0])),
               size = length * view.scale;
  Point origin{view.left + from_left, view.bottom - from_bottom - picture_text_size};
  for (const SpaceAxis& axis : axes) {  // so that all of them have room
    origin.x = std::max(origin.x, view.left + from_left - size * std::min(axis.right, 0.0));
    origin.y = std::min(origin.y, view.bottom - from_bottom - picture_text_size + size * std::min(axis.up, 0.0) - gap);
  }
  for (const SpaceAxis& axis : axes) {
    const double along = std::hypot(axis.right, axis.up);
    if (!(along > 0.05)) continue;  // towards whoever looks
    const Point unit{axis.right / along, -axis.up / along};
    const Point tip{origin.x + size * axis.right, origin.y - size * axis.up};
    canvas.stroke(std::array{origin, tip}, 1.8, ink);
    const auto behind = [&](double aside) {
      return Point{tip.x - head * unit.x - aside * unit.y, tip.y - head * unit.y + aside * unit.x};
    };
    canvas.fill(std::array{Point{tip.x + 3 * unit.x, tip.y + 3 * unit.y}, behind(4), behind(-4)}, ink);
    canvas.text({tip.x + gap * unit.x, tip.y + gap * unit.y + 0.35 * picture_text_size}, axis.name,
                {picture_text_size, ink, Anchor::middle});
  }
  canvas.text({view.left + from_left - 10, view.bottom - from_bottom + picture_text_size * 0.5},
              rounded_text(length, 4) + " " + view.picture.length_unit, {picture_text_size, ink, Anchor::left});
}

void draw_frame_axes(Canvas& canvas, const View& view, const Layout& layout, bool with_y) {
  const ParticlePicture& picture = view.picture;
  const int target = layout.panel_width > 600 ? 6 : 4;
  const auto axis = [&](std::size_t d) {
    return make_axis(picture.lower[d], picture.upper[d], false, Fit::tight, target);
  };
  const auto title = [&](const std::string& name, const Axis& along) {
    return name + (along.factor.empty() ? "" : " (" + along.factor + ")") + " [" + picture.length_unit + "]";
  };
  const Axis x = axis(0), y = axis(1);
  draw(canvas,
       PanelAxes{view.left, view.top, view.left + layout.panel_width, view.bottom, x, y, title(picture.x_label, x),
                 title(picture.y_label, y), 50, [&](double u, double v) { return view.at(u, v); }, with_y});
}

void check(const ParticlePicture& picture) {
  if (picture.frames.empty()) throw std::invalid_argument("ParticlePicture: no frame");
  for (const ParticleFrame& f : picture.frames) {
    if (f.value.size() != f.size()) throw std::invalid_argument("ParticlePicture: arrays of different lengths");
    if (!f.polygons.empty()) continue;
    const std::size_t n = f.x.size();
    for (const auto* array : {&f.y, &f.r1x, &f.r1y, &f.r2x, &f.r2y, &f.value}) {
      if (array->size() != n) throw std::invalid_argument("ParticlePicture: arrays of different lengths");
    }
  }
}

}  // namespace

std::string png(const HeatMap& map) {
  if (map.columns == 0 || map.rows == 0 || map.values.size() != map.columns * map.rows) {
    throw std::invalid_argument("HeatMap: values do not fit rows and columns");
  }
  const std::array<double, 2> range = color_range(map.values, map.map);
  const Axis x = make_axis(map.x[0], map.x[1], false, Fit::tight, 7);
  const Axis y = make_axis(map.y[0], map.y[1], false, Fit::tight, 6);
  const double left = 44 + y.widest_label(picture_text_size), right = left + panel_width;
  const double bottom = panel_top + panel_height;
  const PlotFrame panel{left, panel_top, right, bottom, x, y};
  const ColorBar bar{
      map.map, make_axis(range[0], range[1], false, Fit::tight, 8), map.value_label, right + 28, panel_top, bottom};
  Canvas canvas(static_cast<int>(std::ceil(bar.left + bar.width())), static_cast<int>(bottom + 70), paper);
  canvas.text({left, 34}, map.title, {picture_text_size * 1.2, ink, Anchor::left});
  canvas.clip(left, panel_top, right, bottom);
  draw_cells(canvas, map, panel, bar);
  draw_lines(canvas, map, panel);
  canvas.unclip();
  const auto at = [&](double u, double v) { return panel.at(u, v); };
  draw(canvas,
       PanelAxes{left, panel_top, right, bottom, x, y, x.titled(map.x_label), y.titled(map.y_label), 52, at, true});
  draw(canvas, bar);
  return canvas.png();
}

std::string png(const ParticlePicture& picture) {
  check(picture);
  const std::array<double, 2> range = color_range(picture);
  ColorBar bar{picture.map, make_axis(range[0], range[1], false, Fit::tight, picture.frames.size() == 1 ? 8 : 6),
               picture.value_label};
  const Layout layout = lay_out(picture, bar);
  bar.left = layout.bar_left, bar.top = layout.top, bar.bottom = layout.top + layout.panel_height;
  Canvas canvas(static_cast<int>(std::ceil(layout.width)), static_cast<int>(std::ceil(layout.height)), paper);
  if (!picture.title.empty())
    canvas.text({layout.left, 36}, picture.title, {picture_text_size * 1.2, ink, Anchor::left});
  for (std::size_t i = 0; i < picture.frames.size(); ++i) {
    const double left = layout.left + static_cast<double>(i) * (layout.panel_width + layout.gap);
    const View view{picture, left, layout.top, layout.panel_width / (picture.upper[0] - picture.lower[0]),
                    layout.top + layout.panel_height};
    canvas.clip(left, layout.top, left + layout.panel_width, view.bottom);
    draw_particles(canvas, view, picture.frames[i], bar);
    draw_rings(canvas, view);
    canvas.unclip();
    draw_space_axes(canvas, view);
    if (!picture.x_label.empty()) draw_frame_axes(canvas, view, layout, i == 0);
    canvas.text({left + layout.panel_width / 2, layout.top - 12}, picture.frames[i].caption,
                {picture_text_size, ink, Anchor::middle});
  }
  draw(canvas, bar);
  return canvas.png();
}

}  // namespace assay::drivers
