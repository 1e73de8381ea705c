// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/stroke_font.hpp"

#include <charconv>
#include <map>
#include <sstream>

#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// A line a glyph: its code in hexadecimal digits, its width, its path. M x y, L x y, Q cx cy x y as in SVG; D x y is a
/// dot.
constexpr std::string_view glyph_lines =
#include "stroke_font.inc"
    ;

class PathReader {
 public:
  explicit PathReader(std::string_view path) : rest_(path) {}
  Glyph read(double width) {
    Glyph out{width, {}};
    while (!rest_.empty()) {
      const char command = rest_[0];
      rest_.remove_prefix(1);
      if (command == 'Q') {
        const GlyphPoint control = point(), end = point();
        curve(out.strokes.back(), control, end);
      } else {
        if (command != 'L') out.strokes.emplace_back();
        out.strokes.back().push_back(point());
      }
    }
    return out;
  }

 private:
  double number() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    double value = 0;
    const auto done = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    rest_.remove_prefix(static_cast<std::size_t>(done.ptr - rest_.data()));
    return value;
  }
  GlyphPoint point() {
    const double x = number();
    return {x, number()};
  }
  static void curve(std::vector<GlyphPoint>& stroke, GlyphPoint control, GlyphPoint end) {
    const GlyphPoint start = stroke.back();
    // Between parabola and superellipse: a quarter that looks round.
    const auto blend = [](GlyphPoint a, GlyphPoint b) {
      return GlyphPoint{a.x + 0.552 * (b.x - a.x), a.y + 0.552 * (b.y - a.y)};
    };
    const GlyphPoint c1 = blend(start, control), c2 = blend(end, control);
    for (int i = 1; i <= 10; ++i) {
      const double t = i / 10.0, s = 1 - t;
      const double w0 = s * s * s, w1 = 3 * s * s * t, w2 = 3 * s * t * t, w3 = t * t * t;
      stroke.push_back(
          {w0 * start.x + w1 * c1.x + w2 * c2.x + w3 * end.x, w0 * start.y + w1 * c1.y + w2 * c2.y + w3 * end.y});
    }
  }
  std::string_view rest_;
};

std::map<char32_t, Glyph> read_font() {
  std::map<char32_t, Glyph> font;
  std::istringstream lines{std::string(glyph_lines)};
  std::uint32_t code = 0;
  double width = 0;
  for (std::string path; lines >> std::hex >> code >> width && std::getline(lines, path);) {
    font[code] = PathReader(std::string_view(path).substr(path.empty() ? 0 : 1)).read(width);
  }
  return font;
}

}  // namespace

const Glyph& glyph(char32_t code) {
  static const std::map<char32_t, Glyph> font = read_font();
  const auto found = font.find(code);
  return found == font.end() ? font.at(U'\ufffd') : found->second;
}

std::vector<char32_t> code_points(std::string_view text) {
  std::vector<char32_t> out;
  for_each_character(text, [&](std::uint32_t code, std::string_view) {
    out.push_back(code == no_character ? U'\ufffd' : static_cast<char32_t>(code));
  });
  return out;
}

std::vector<LabelPiece> label_pieces(std::string_view label) {
  std::vector<LabelPiece> pieces;
  while (!label.empty()) {
    const bool small = label.size() > 2 && (label[0] == '^' || label[0] == '_') && label[1] == '{';
    const std::size_t end = small ? label.find('}') : std::string_view::npos;
    if (end != std::string_view::npos) {
      pieces.push_back({label.substr(2, end - 2), label[0] == '^' ? 1 : -1});
      label.remove_prefix(end + 1);
      continue;
    }
    const std::size_t next = std::min(std::min(label.find("^{", 1), label.find("_{", 1)), label.size());
    pieces.push_back({label.substr(0, next), 0});
    label.remove_prefix(next);
  }
  return pieces;
}

double label_width(std::string_view label, double size) {
  double units = 0;
  for (const LabelPiece& piece : label_pieces(label)) {
    for (const char32_t code : code_points(piece.text)) {
      units += (glyph(code).width + glyph_gap) * (piece.level == 0 ? 1 : small_scale);
    }
  }
  return units * size / glyph_em;
}

}  // namespace assay::drivers
