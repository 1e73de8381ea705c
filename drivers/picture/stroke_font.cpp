// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/stroke_font.hpp"

#include <charconv>
#include <map>

namespace assay::drivers {

namespace {

struct Drawn {
  char32_t code;
  double width;
  const char* path;  ///< M x y, L x y, Q cx cy x y as in SVG; D x y is a dot
};

constexpr Drawn drawn[] = {
    {U' ', 4, ""},
    {U'!', 2, "M1 20L1 6D1 0.5"},
    {U'"', 6, "M1 20L1 14M5 20L5 14"},
    {U'#', 14, "M5 19L3 1M11 19L9 1M1 13L14 13M0 7L13 7"},
    {U'$', 13, "M12 16Q10 18 6.5 18Q1 18 1 14Q1 10.5 6.5 10Q13 9.3 13 5.5Q13 2 6.5 2Q3 2 0 4.5M6.5 22L6.5 -2"},
    {U'%', 18,
     "M15 20L3 0M4 20Q0 20 0 15.5Q0 11 4 11Q8 11 8 15.5Q8 20 4 20M14 9Q10 9 10 4.5Q10 0 14 0Q18 0 18 4.5Q18 9 14 9"},
    {U'&', 16, "M16 0L3.5 14Q1.5 20 6 20Q10.5 20 9 15Q8 13 4 11Q0 9 0 5Q0 0 6 0Q12 0 15 9"},
    {U'\'', 2, "M1 20L1 14"},
    {U'(', 5, "M5 23Q0 17 0 8.5Q0 0 5 -6"},
    {U')', 5, "M0 23Q5 17 5 8.5Q5 0 0 -6"},
    {U'*', 9, "M4.5 20L4.5 10M0 17.5L9 12.5M0 12.5L9 17.5"},
    {U'+', 12, "M6 2L6 14M0 8L12 8"},
    {U',', 3, "M2 1.5L0.5 -4"},
    {U'-', 8, "M0 7.5L8 7.5"},
    {U'.', 2, "D1 0.5"},
    {U'/', 9, "M0 -3L9 22"},
    {U'0', 12, "M6 20Q0 20 0 10Q0 0 6 0Q12 0 12 10Q12 20 6 20"},
    {U'1', 12, "M2.5 16L7.5 20L7.5 0"},
    {U'2', 12, "M0.5 15Q0.5 20 6 20Q11.5 20 11.5 15Q11.5 11.5 8 8L0 0L12 0"},
    {U'3', 12, "M1 17Q2.5 20 6 20Q11 20 11 15.3Q11 10.7 5 10.7Q12 10.7 12 5.4Q12 0 6 0Q2 0 0 3.5"},
    {U'4', 12, "M9 0L9 20L0 6L12 6"},
    {U'5', 12, "M11 20L2 20L1 11Q3 13 6 13Q12 13 12 6.5Q12 0 6 0Q2 0 0 3"},
    {U'6', 12, "M10.5 18.5Q9 20 6.5 20Q0 20 0 9Q0 0 6 0Q12 0 12 6.3Q12 12.5 6 12.5Q0.5 12.5 0 7"},
    {U'7', 12, "M0 20L12 20L4 0"},
    {U'8', 12,
     "M6 10.7Q1 10.7 1 15.3Q1 20 6 20Q11 20 11 15.3Q11 10.7 6 10.7Q0 10.7 0 5.4Q0 0 6 0Q12 0 12 5.4Q12 10.7 6 10.7"},
    {U'9', 12, "M1.5 1.5Q3 0 5.5 0Q12 0 12 11Q12 20 6 20Q0 20 0 13.7Q0 7.5 6 7.5Q11.5 7.5 12 13"},
    {U':', 2, "D1 0.5D1 11"},
    {U';', 3, "M2 1.5L0.5 -4D2 11"},
    {U'<', 11, "M11 14L0 8L11 2"},
    {U'=', 12, "M0 11L12 11M0 5L12 5"},
    {U'>', 11, "M0 14L11 8L0 2"},
    {U'?', 11, "M0 15.5Q0 20 5.5 20Q11 20 11 15.5Q11 12 7.5 10Q5.5 9 5.5 6D5.5 0.5"},
    {U'@', 20,
     "M14 10Q14 14 10 14Q6 14 6 9Q6 4 9.5 4Q14 4 14 10M14 14L14 7Q14 4 17 4Q20 4 20 10Q20 20 10 20Q0 20 0 9.5Q0 -3 10 "
     "-3Q14 -3 16 -1.5"},
    {U'A', 16, "M0 0L8 20L16 0M3 7L13 7"},
    {U'B', 14, "M0 10L8 10Q14 10 14 5Q14 0 8 0L0 0L0 20L7 20Q13 20 13 15Q13 10 7 10"},
    {U'C', 15, "M15 17Q12 20 9 20Q0 20 0 10Q0 0 9 0Q12 0 15 3"},
    {U'D', 15, "M0 0L0 20L6 20Q15 20 15 10Q15 0 6 0L0 0"},
    {U'E', 12, "M12 20L0 20L0 0L12 0M0 10L10 10"},
    {U'F', 12, "M12 20L0 20L0 0M0 10L10 10"},
    {U'G', 16, "M15 17Q12 20 9 20Q0 20 0 10Q0 0 9 0Q13 0 16 3L16 9L10 9"},
    {U'H', 15, "M0 0L0 20M15 0L15 20M0 10L15 10"},
    {U'I', 2, "M1 0L1 20"},
    {U'J', 9, "M9 20L9 5Q9 0 4.5 0Q0 0 0 5"},
    {U'K', 14, "M0 0L0 20M14 20L0 7M5 11.5L14 0"},
    {U'L', 11, "M0 20L0 0L11 0"},
    {U'M', 18, "M0 0L0 20L9 5L18 20L18 0"},
    {U'N', 15, "M0 0L0 20L15 0L15 20"},
    {U'O', 18, "M9 20Q0 20 0 10Q0 0 9 0Q18 0 18 10Q18 20 9 20"},
    {U'P', 14, "M0 0L0 20L8 20Q14 20 14 14.5Q14 9 8 9L0 9"},
    {U'Q', 18, "M9 20Q0 20 0 10Q0 0 9 0Q18 0 18 10Q18 20 9 20M11 5L18 -2"},
    {U'R', 14, "M0 0L0 20L8 20Q14 20 14 14.5Q14 9 8 9L0 9M7 9L14 0"},
    {U'S', 14, "M13 17Q10 20 7 20Q1 20 1 15Q1 11 7 10.3Q14 9.5 14 5Q14 0 7 0Q3 0 0 3"},
    {U'T', 14, "M0 20L14 20M7 20L7 0"},
    {U'U', 15, "M0 20L0 7Q0 0 7.5 0Q15 0 15 7L15 20"},
    {U'V', 16, "M0 20L8 0L16 20"},
    {U'W', 22, "M0 20L5.5 0L11 18L16.5 0L22 20"},
    {U'X', 15, "M0 0L15 20M0 20L15 0"},
    {U'Y', 16, "M0 20L8 10L16 20M8 10L8 0"},
    {U'Z', 14, "M0 20L14 20L0 0L14 0"},
    {U'[', 5, "M5 23L0 23L0 -5L5 -5"},
    {U'\\', 9, "M0 22L9 -3"},
    {U']', 5, "M0 23L5 23L5 -5L0 -5"},
    {U'^', 10, "M0 14L5 20L10 14"},
    {U'_', 12, "M0 -3L12 -3"},
    {U'`', 4, "M0 20L4 16"},
    {U'a', 11, "M11 14L11 0M11 7Q11 14 5.5 14Q0 14 0 7Q0 0 5.5 0Q11 0 11 7"},
    {U'b', 11, "M0 20L0 0M0 7Q0 14 5.5 14Q11 14 11 7Q11 0 5.5 0Q0 0 0 7"},
    {U'c', 10, "M10 12Q8 14 6 14Q0 14 0 7Q0 0 6 0Q8 0 10 2"},
    {U'd', 11, "M11 20L11 0M11 7Q11 14 5.5 14Q0 14 0 7Q0 0 5.5 0Q11 0 11 7"},
    {U'e', 11, "M0 7.5L11 7.5Q11 14 5.5 14Q0 14 0 7Q0 0 6 0Q9 0 10.5 2.5"},
    {U'f', 7, "M7.5 20Q3 20.5 3 15.5L3 0M0 14L7 14"},
    {U'g', 11, "M11 7Q11 14 5.5 14Q0 14 0 7Q0 0 5.5 0Q11 0 11 7M11 14L11 -1Q11 -6 5.5 -6Q2 -6 0.5 -4.5"},
    {U'h', 10, "M0 20L0 0M0 8Q0 14 5.5 14Q10 14 10 9L10 0"},
    {U'i', 2, "M1 14L1 0D1 19.5"},
    {U'j', 4, "M3 14L3 -2Q3 -6 -1 -6D3 19.5"},
    {U'k', 10, "M0 20L0 0M10 14L0 5M4 8.5L10 0"},
    {U'l', 2, "M1 20L1 0"},
    {U'm', 17, "M0 14L0 0M0 8Q0 14 4.5 14Q8.5 14 8.5 9L8.5 0M8.5 8Q8.5 14 13 14Q17 14 17 9L17 0"},
    {U'n', 10, "M0 14L0 0M0 8Q0 14 5.5 14Q10 14 10 9L10 0"},
    {U'o', 12, "M6 14Q0 14 0 7Q0 0 6 0Q12 0 12 7Q12 14 6 14"},
    {U'p', 11, "M0 14L0 -6M0 7Q0 14 5.5 14Q11 14 11 7Q11 0 5.5 0Q0 0 0 7"},
    {U'q', 11, "M11 14L11 -6M11 7Q11 14 5.5 14Q0 14 0 7Q0 0 5.5 0Q11 0 11 7"},
    {U'r', 6, "M0 14L0 0M0 8Q0.5 14 6.5 14"},
    {U's', 9.5, "M9 12Q7.5 14 5 14Q0.5 14 0.5 10.8Q0.5 7.8 5 7.2Q9.5 6.5 9.5 3.5Q9.5 0 5 0Q1.5 0 0 2.2"},
    {U't', 7, "M3 19L3 4Q3 0 7.5 0.3M0 14L7 14"},
    {U'u', 10, "M0 14L0 5Q0 0 4.5 0Q10 0 10 6M10 14L10 0"},
    {U'v', 11, "M0 14L5.5 0L11 14"},
    {U'w', 17, "M0 14L4.2 0L8.5 13L12.8 0L17 14"},
    {U'x', 10, "M0 0L10 14M0 14L10 0"},
    {U'y', 11, "M0 14L5.5 0M11 14L4.5 -3.5Q3.5 -6 0 -6"},
    {U'z', 10, "M0 14L10 14L0 0L10 0"},
    {U'{', 6, "M6 23Q3 23 3 20L3 12Q3 8.5 0 8.5Q3 8.5 3 5L3 -3Q3 -6 6 -6"},
    {U'|', 2, "M1 23L1 -6"},
    {U'}', 6, "M0 23Q3 23 3 20L3 12Q3 8.5 6 8.5Q3 8.5 3 5L3 -3Q3 -6 0 -6"},
    {U'~', 12, "M0 7Q1 10 3.5 10Q5 10 6 8.5Q7 7 8.5 7Q11 7 12 10"},
    {U'\u00b0', 7, "M3.5 20Q0 20 0 16.5Q0 13 3.5 13Q7 13 7 16.5Q7 20 3.5 20"},
    {U'\u00b7', 3, "D1.5 8"},
    {U'\u00d7', 10, "M0 3L10 13M0 13L10 3"},
    {U'\u0394', 16, "M0 0L8 20L16 0L0 0"},
    {U'\u03b1', 13, "M13 14Q10 0 5.5 0Q0 0 0 7Q0 14 5.5 14Q10 14 13 0"},
    {U'\u03b3', 11, "M0 13Q3 16 5 9L6.5 2M11 14L6.5 2Q4 -3 4.5 -5Q5.5 -7 6.7 -5Q7 -3 6.5 2"},
    {U'\u03b5', 10, "M9 12.5Q7.5 14 5 14Q0.5 14 0.5 10.7Q0.5 7.5 5 7.5Q0 7.5 0 3.8Q0 0 5 0Q8 0 10 2"},
    {U'\u03b8', 11, "M5.5 20Q0 20 0 10Q0 0 5.5 0Q11 0 11 10Q11 20 5.5 20M0 10L11 10"},
    {U'\u03be', 10, "M2 20L9.5 20Q2 19 2 15.3Q2 12 8 12Q0 12 0 6.5Q0 1.5 6 1Q10 0 9.3 -3Q8.5 -5.5 5 -5.5"},
    {U'\u03c1', 11, "M0 -6L0 7Q0 14 5.5 14Q11 14 11 7Q11 0 5.5 0Q0 0 0 6"},
    {U'\u03c3', 12.5, "M12.5 14L6 14Q0 14 0 7Q0 0 5.5 0Q11 0 11 7Q11 12 7 14"},
    {U'\u03c4', 11, "M0 13.5L11 13.5M5.5 13.5L5.5 3Q5.5 0 9 0.5"},
    {U'\u2013', 12, "M0 7.5L12 7.5"},
    {U'\u2014', 20, "M0 7.5L20 7.5"},
    {U'\u2212', 12, "M0 8L12 8"},
    {U'\u221e', 18, "M9 7Q6 3 4 3Q0 3 0 7Q0 11 4 11Q6 11 9 7Q12 3 14 3Q18 3 18 7Q18 11 14 11Q12 11 9 7"},
    {U'\u2264', 11, "M11 17L0 11L11 5M0 1L11 1"},
    {U'\u2265', 11, "M0 17L11 11L0 5M0 1L11 1"},
    {U'\ufffd', 12, "M0 0L12 0L12 20L0 20L0 0"},
};

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
  for (const Drawn& entry : drawn) font[entry.code] = PathReader(entry.path).read(entry.width);
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
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : -1;
    char32_t code = more <= 0 ? lead : lead & (0x3F >> more);
    bool good = more >= 0;
    for (int k = 0; good && k < more; ++k) {
      good = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
      if (good) code = code << 6 | (static_cast<unsigned char>(text[i++]) & 0x3F);
    }
    out.push_back(good ? code : U'\ufffd');
  }
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
