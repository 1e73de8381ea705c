// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "drivers/picture/stroke_font.hpp"

#include <zlib.h>

namespace {

/// Of zlib, which is faster than stb's own and makes a quarter less of it; stb frees what it is given.
unsigned char* zlib_of_picture(unsigned char* data, int size, int* compressed_size, int) {
  constexpr int level = 6;
  uLongf room = compressBound(static_cast<uLong>(size));
  auto* const out = static_cast<unsigned char*>(std::malloc(room));  // NOLINT(cppcoreguidelines-no-malloc)
  if (!out) return nullptr;
  if (compress2(out, &room, data, static_cast<uLong>(size), level) != Z_OK) {
    std::free(out);  // NOLINT(cppcoreguidelines-no-malloc)
    return nullptr;
  }
  *compressed_size = static_cast<int>(room);
  return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS zlib_of_picture
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace assay::drivers {

namespace {

constexpr int fine = 4;  // samples a pixel in each direction

bool finite(std::span<const Point> points) {
  return std::all_of(points.begin(), points.end(), [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

/// The first sample whose centre is not left of `at`.
int first_sample(double at, int low, int high) {
  return static_cast<int>(std::ceil(std::clamp(at, static_cast<double>(low) - 1, static_cast<double>(high) + 1) - 0.5));
}

}  // namespace

Color mix(Color a, Color b, double s) {
  s = std::clamp(s, 0.0, 1.0);
  const auto one = [s](int from, int to) { return static_cast<std::uint8_t>(std::lround(from + (to - from) * s)); };
  return {one(a.r, b.r), one(a.g, b.g), one(a.b, b.b)};
}

Canvas::Canvas(int width, int height, Color background) : width_(width), height_(height), clip_{} {
  if (width < 1 || height < 1 || width > 20000 || height > 20000) throw std::invalid_argument("Canvas: size");
  samples_.assign(static_cast<std::size_t>(width) * fine * static_cast<std::size_t>(height) * fine, background);
  unclip();
}

void Canvas::clip(double left, double top, double right, double bottom) {
  const int w = width_ * fine, h = height_ * fine;
  clip_ = {std::clamp(first_sample(left * fine, 0, w), 0, w), std::clamp(first_sample(top * fine, 0, h), 0, h),
           std::clamp(first_sample(right * fine, 0, w), 0, w), std::clamp(first_sample(bottom * fine, 0, h), 0, h)};
}

void Canvas::unclip() { clip_ = {0, 0, width_ * fine, height_ * fine}; }

void Canvas::row(int y, double left, double right, Color color) {
  const int first = std::max(first_sample(left, clip_[0], clip_[2]), clip_[0]);
  const int last = std::min(first_sample(right, clip_[0], clip_[2]), clip_[2]);
  if (first >= last) return;
  const auto line = samples_.begin() + static_cast<std::ptrdiff_t>(y) * width_ * fine;
  std::fill(line + first, line + last, color);
}

void Canvas::fill(std::span<const Point> polygon, Color color) {
  if (polygon.size() < 3 || !finite(polygon)) return;
  double top = INFINITY, bottom = -INFINITY;
  scaled_.clear();
  for (const Point p : polygon) {
    scaled_.push_back({p.x * fine, p.y * fine});
    top = std::min(top, p.y * fine);
    bottom = std::max(bottom, p.y * fine);
  }
  const int first = std::max(first_sample(top, clip_[1], clip_[3]), clip_[1]);
  const int last = std::min(first_sample(bottom, clip_[1], clip_[3]), clip_[3]);
  for (int y = first; y < last; ++y) {
    const double at = y + 0.5;
    crossings_.clear();
    for (std::size_t i = 0, n = scaled_.size(); i < n; ++i) {
      // From the upper to the lower end, so that both polygons at an edge compute the same crossing.
      Point a = scaled_[i], b = scaled_[i + 1 == n ? 0 : i + 1];
      if (a.y > b.y) std::swap(a, b);
      if (a.y <= at && at < b.y) crossings_.push_back(a.x + (b.x - a.x) * ((at - a.y) / (b.y - a.y)));
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) row(y, crossings_[i], crossings_[i + 1], color);
  }
}

void Canvas::circle(Point center, double radius, Color color) {
  if (!std::isfinite(center.x) || !std::isfinite(center.y) || !(radius > 0)) return;
  const double r = radius * fine, cx = center.x * fine, cy = center.y * fine;
  const int first = std::max(first_sample(cy - r, clip_[1], clip_[3]), clip_[1]);
  const int last = std::min(first_sample(cy + r, clip_[1], clip_[3]), clip_[3]);
  for (int y = first; y < last; ++y) {
    const double dy = y + 0.5 - cy, half = std::sqrt(std::max(0.0, r * r - dy * dy));
    row(y, cx - half, cx + half, color);
  }
}

void Canvas::segment(Point a, Point b, double width, Color color) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
  circle(a, width / 2, color);
  if (length > 0) {
    const double nx = -dy / length * width / 2, ny = dx / length * width / 2;
    const std::array<Point, 4> quad{
        {{a.x + nx, a.y + ny}, {b.x + nx, b.y + ny}, {b.x - nx, b.y - ny}, {a.x - nx, a.y - ny}}};
    fill(quad, color);
    circle(b, width / 2, color);
  }
}

void Canvas::stroke(std::span<const Point> line, double width, Color color, double dash) {
  if (line.empty() || !finite(line)) return;
  if (line.size() == 1) return circle(line[0], width / 2, color);
  if (!(dash > 0)) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) segment(line[i], line[i + 1], width, color);
    return;
  }
  double walked = 0;  // along the whole line, so that dashes run through its joints
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point a = line[i], b = line[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0) || length > 1e6) continue;
    const auto at = [&](double s) { return Point{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length}; };
    for (double s = 0; s < length;) {
      const double phase = std::fmod(walked + s, 2 * dash);
      const double end = std::min(length, s + std::max(1e-6, (phase < dash ? dash : 2 * dash) - phase));
      if (phase < dash) segment(at(s), at(end), width, color);
      s = end;
    }
    walked += length;
  }
}

void Canvas::text(Point at, std::string_view label, const TextStyle& style) {
  const double shift = style.anchor == Anchor::left ? 0 : style.anchor == Anchor::middle ? 0.5 : 1;
  const double width = (label_width(label, style.size) - glyph_gap * style.size / glyph_em) * shift;
  at = style.upwards ? Point{at.x, at.y + width} : Point{at.x - width, at.y};
  double along = 0;
  for (const LabelPiece& piece : label_pieces(label)) {
    const double size = style.size * (piece.level == 0 ? 1 : small_scale), unit = size / glyph_em;
    const double rise = piece.level > 0 ? raise * style.size : piece.level < 0 ? -lower * style.size : 0;
    const double pen = std::max(0.095 * size, 0.9);
    for (const char32_t code : code_points(piece.text)) {
      const Glyph& shape = glyph(code);
      for (const auto& stroke_points : shape.strokes) {
        std::vector<Point> line;
        for (const GlyphPoint p : stroke_points) {
          const double right = along + p.x * unit, up = rise + p.y * unit;
          line.push_back(style.upwards ? Point{at.x - up, at.y - right} : Point{at.x + right, at.y - up});
        }
        stroke(line, line.size() == 1 ? 1.35 * pen : pen, style.color);
      }
      along += (shape.width + glyph_gap) * unit;
    }
  }
}

Color Canvas::pixel(int x, int y) const {
  std::array<int, 3> sum{};
  for (int j = 0; j < fine; ++j) {
    const std::size_t line = static_cast<std::size_t>(y * fine + j) * static_cast<std::size_t>(width_ * fine);
    for (int i = 0; i < fine; ++i) {
      const Color sample = samples_[line + static_cast<std::size_t>(x * fine + i)];
      sum[0] += sample.r;
      sum[1] += sample.g;
      sum[2] += sample.b;
    }
  }
  const auto mean = [](int total) { return static_cast<std::uint8_t>((total + fine * fine / 2) / (fine * fine)); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

std::string Canvas::png() const {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3);
  std::uint8_t* next = bytes.data();
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const Color c = pixel(x, y);
      for (const std::uint8_t value : {c.r, c.g, c.b}) *next++ = value;
    }
  }
  std::string out;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &out, width_, height_, 3, bytes.data(), width_ * 3)) {
    throw std::bad_alloc();  // the one reason that it has
  }
  return out;
}

}  // namespace assay::drivers
