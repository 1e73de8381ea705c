// SPDX-License-Identifier: BSD-3-Clause
// An anti-aliased RGB picture. Pixel coordinates: x to the right, y downwards, (0,0) the upper left corner.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

struct Point {
  double x = 0, y = 0;
};

struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Color&) const = default;
};

/// 0xRRGGBB.
constexpr Color rgb(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(value)};
}

/// a (1 - s) + b s.
Color mix(Color a, Color b, double s);

enum class Anchor { left, middle, right };

struct TextStyle {
  double size = 14;  ///< em [pixel]
  Color color;
  Anchor anchor = Anchor::left;
  bool upwards = false;  ///< written from bottom to top
};

/// Everything is drawn opaque on 4 x 4 samples a pixel, so that shapes that share an edge leave no seam. What is not
/// finite or lies outside is not drawn. The same calls give the same bytes.
class Canvas {
 public:
  Canvas(int width, int height, Color background);
  int width() const { return width_; }
  int height() const { return height_; }

  /// Until unclip() only the pixels of this rectangle are drawn.
  void clip(double left, double top, double right, double bottom);
  void unclip();

  /// Inside of a closed polygon, even-odd rule.
  void fill(std::span<const Point> polygon, Color color);
  void circle(Point center, double radius, Color color);
  /// A line with round joints and ends; `dash` > 0: dashes of that length with gaps of the same [pixel].
  void stroke(std::span<const Point> line, double width, Color color, double dash = 0);
  /// `at` is the anchor on the baseline. UTF-8, ^{..} raised, _{..} lowered.
  void text(Point at, std::string_view label, const TextStyle& style);

  Color pixel(int x, int y) const;
  /// The picture as a PNG file.
  std::string png() const;

 private:
  void segment(Point a, Point b, double width, Color color);
  void row(int y, double left, double right, Color color);

  int width_, height_;
  std::array<int, 4> clip_;  ///< left, top, right, bottom in samples
  std::vector<Color> samples_;
  std::vector<Point> scaled_;
  std::vector<double> crossings_;
};

}  // namespace assay::drivers
