// SPDX-License-Identifier: BSD-3-Clause
// A figure as a list of lines, dots and labels, so that its SVG and its PNG are one figure.
#pragma once

#include <string>
#include <vector>

#include "drivers/picture/canvas.hpp"

namespace assay::drivers {

/// What something is drawn for: the SVG leaves the colour to the page's theme, the PNG is for white paper.
struct Ink {
  enum class Role {
    text,
    axis,
    grid,
    series,
    name,   ///< text that names a series: its colour, dark or light enough to be read
    faint,  ///< series that stand back
    band,   ///< a broad line behind others
    fixed,  ///< `color` on any page
  };
  Role role = Role::text;
  std::size_t series = 0;
  Color color = {};
};

struct DrawingItem {
  enum class Kind { line, disc, label, area };
  Kind kind = Kind::line;
  Ink ink;
  std::vector<Point> points;  ///< of a line or around an area; one for a disc or a label
  double size = 1;            ///< width of a line, radius of a disc, em of a label
  double dash = 0;
  std::string label = {};
  Anchor anchor = Anchor::left;
  bool upwards = false;
  std::string tip = {};  ///< shown where a pointer rests on it
};

struct Drawing {
  double width = 0, height = 0;
  std::string title;  ///< for those who cannot see it
  std::vector<DrawingItem> items;

  void line(std::vector<Point> points, Ink ink, double width, double dash = 0);
  void disc(Point center, double radius, Ink ink);
  void label(Point at, std::string text, double size, Anchor anchor, Ink ink = {}, bool upwards = false);
  void area(std::vector<Point> around, Ink ink);
  /// Of what was drawn last.
  void tip(std::string text);
};

/// An inline <svg> element: text and axes in currentColor, series k in the CSS variable --series-k and its
/// name in --name-k, each with a default.
std::string svg_text(const Drawing& drawing);

/// `scale` pixels a unit.
Canvas raster(const Drawing& drawing, double scale);

/// "#rrggbb".
std::string css_color(Color color);

/// Text for HTML and XML, in element content and in attributes.
std::string escaped(std::string_view text);

}  // namespace assay::drivers
