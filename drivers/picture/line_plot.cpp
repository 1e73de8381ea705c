// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/line_plot.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/picture/stroke_font.hpp"
#include "drivers/picture/ticks.hpp"

namespace assay::drivers {

namespace {

constexpr double plot_width = 600, plot_height = 400, plot_text_size = 14;
constexpr Ink text_ink{Ink::Role::text, 0}, axis_ink{Ink::Role::axis, 0}, grid_ink{Ink::Role::grid, 0};

/// What an axis can hold: finite, positive where logarithmic, and not at the very ends of the doubles.
bool usable(double value, bool logarithmic) { return std::abs(value) < 1e280 && (!logarithmic || value > 1e-280); }

struct Placed {
  double x, y;
};

/// The runs of consecutive points that can be drawn.
std::vector<std::vector<Placed>> runs(const LinePlot& plot, const Series& series) {
  std::vector<std::vector<Placed>> out(1);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (usable(series.x[i], plot.log_x) && usable(series.y[i], plot.log_y)) {
      out.back().push_back({series.x[i], series.y[i]});
    } else if (!out.back().empty()) {
      out.emplace_back();
    }
  }
  if (out.back().empty()) out.pop_back();
  return out;
}

/// Axes around all data; without any, of the unit square.
bool fit_axes(const LinePlot& plot, PlotFrame& frame) {
  Extent x, y;
  bool markers = false;
  for (const Series& series : plot.series) {
    markers = markers || series.markers;
    // The ends of x do not depend on which y can be drawn: the error at t = 0 is zero.
    for (const double at : series.x) {
      if (usable(at, plot.log_x)) x.add(at);
    }
    for (const auto& run : runs(plot, series)) {
      for (const Placed p : run) y.add(p.y);
    }
  }
  const bool empty = y.empty();
  if (x.empty()) x = {plot.log_x ? 0.1 : 0, 1};
  if (empty) y = {plot.log_y ? 0.1 : 0, 1};
  // Zero belongs to the picture of a magnitude.
  if (!plot.log_y && y.low > 0 && y.low < 0.4 * y.high) y.low = 0;
  frame.x = make_axis(x.low, x.high, plot.log_x, markers || plot.log_x ? Fit::rounded : Fit::tight, 7);
  frame.y = make_axis(y.low, y.high, plot.log_y, Fit::rounded, 6);
  return !empty;
}

/// Rows of the legend above the curves, where it hides none of them; returns their height.
double draw_legend(Drawing& out, const LinePlot& plot, double left, double right, double top) {
  constexpr double row_height = 20, sample = 28, gap = 22;
  double x = left, y = top;
  bool any = false;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty()) continue;
    const double width = sample + 8 + label_width(series.name, plot_text_size * 0.93);
    if (any && x + width > right) x = left, y += row_height;
    const Ink ink{Ink::Role::series, i};
    const double middle = y + row_height / 2 - 2;
    if (series.line) out.line({{x, middle}, {x + sample, middle}}, ink, 2, series.dashed ? 5 : 0);
    if (series.markers) out.disc({x + sample / 2, middle}, 3.5, ink);
    out.label({x + sample + 8, middle + 5}, series.name, plot_text_size * 0.93, Anchor::left);
    x += width + gap;
    any = true;
  }
  return any ? y + row_height + 2 - top : 0;
}

void draw_axes(Drawing& out, const LinePlot& plot, const PlotFrame& f) {
  const double small = plot_text_size * 0.93;
  for (std::size_t i = 0; i < f.x.major.size(); ++i) {
    const double x = f.at(f.x.major[i], f.y.low).x;
    out.line({{x, f.top}, {x, f.bottom}}, grid_ink, 1);
    out.line({{x, f.bottom}, {x, f.bottom + 5}}, axis_ink, 1);
    out.label({x, f.bottom + 20}, f.x.labels[i], small, Anchor::middle);
  }
  for (std::size_t i = 0; i < f.y.major.size(); ++i) {
    const double y = f.at(f.x.low, f.y.major[i]).y;
    out.line({{f.left, y}, {f.right, y}}, grid_ink, 1);
    out.line({{f.left - 5, y}, {f.left, y}}, axis_ink, 1);
    out.label({f.left - 9, y + 5}, f.y.labels[i], small, Anchor::right);
  }
  for (const double minor : f.x.minor) {
    const double x = f.at(minor, f.y.low).x;
    out.line({{x, f.bottom}, {x, f.bottom + 3}}, axis_ink, 0.8);
  }
  for (const double minor : f.y.minor) {
    const double y = f.at(f.x.low, minor).y;
    out.line({{f.left - 3, y}, {f.left, y}}, axis_ink, 0.8);
  }
  out.line({{f.left, f.top}, {f.left, f.bottom}, {f.right, f.bottom}}, axis_ink, 1.2);
  out.label({(f.left + f.right) / 2, f.bottom + 44}, f.x.titled(plot.x_label), plot_text_size, Anchor::middle);
  out.label({plot_text_size + 2, (f.top + f.bottom) / 2}, f.y.titled(plot.y_label), plot_text_size, Anchor::middle,
            text_ink, true);
}

void draw_series(Drawing& out, const LinePlot& plot, const PlotFrame& f, std::size_t index) {
  const Series& series = plot.series[index];
  const Ink ink{Ink::Role::series, index};
  for (const auto& run : runs(plot, series)) {
    std::vector<Point> line;
    for (const Placed p : run) line.push_back(f.at(p.x, p.y));
    // A point without neighbours would be invisible as a line.
    if (series.markers || line.size() == 1) {
      for (const Point p : line) out.disc(p, 3.5, ink);
    }
    if (series.line && line.size() > 1) out.line(std::move(line), ink, 2, series.dashed ? 6 : 0);
  }
}

}  // namespace

Drawing draw(const LinePlot& plot) {
  Drawing out{plot_width, plot_height, plot.title, {}};
  PlotFrame frame;
  const bool any = fit_axes(plot, frame);
  frame.left = plot_text_size + 24 + frame.y.widest_label(plot_text_size * 0.93);
  frame.right = plot_width - 18;
  frame.top = 10;
  if (!plot.title.empty()) {
    out.label({frame.left, 22}, plot.title, plot_text_size * 1.1, Anchor::left);
    frame.top = 34;
  }
  frame.top += draw_legend(out, plot, frame.left, frame.right, frame.top);
  frame.bottom = frame.top + 300;
  out.height = frame.bottom + 54;
  draw_axes(out, plot, frame);
  if (any) {
    for (std::size_t i = 0; i < plot.series.size(); ++i) draw_series(out, plot, frame, i);
  } else {
    out.label({(frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2}, "no data", plot_text_size,
              Anchor::middle);
  }
  return out;
}

std::string svg(const LinePlot& plot) { return svg_text(draw(plot)); }

std::string png(const LinePlot& plot, double scale) { return raster(draw(plot), scale).png(); }

}  // namespace assay::drivers
