// SPDX-License-Identifier: BSD-3-Clause
// A small font of strokes, so that pictures need no font file. Units: cap height 20, x-height 14, baseline 0, y
// upwards.
#pragma once

#include <string_view>
#include <vector>

namespace assay::drivers {

struct GlyphPoint {
  double x = 0, y = 0;
};

struct Glyph {
  double width = 0;                              ///< of the ink box; the gap between letters comes on top
  std::vector<std::vector<GlyphPoint>> strokes;  ///< polylines; one of a single point is a dot
};

inline constexpr double glyph_em = 28;    ///< units of one em
inline constexpr double glyph_gap = 4.6;  ///< units between two letters

/// The glyph of a code point: ASCII and the few symbols that labels need; a box for the rest.
const Glyph& glyph(char32_t code);

/// Code points of UTF-8 text; what is no UTF-8 gives U+FFFD.
std::vector<char32_t> code_points(std::string_view text);

/// A piece of a label: "10^{-3}" and "r_{a}" hold raised and lowered pieces.
struct LabelPiece {
  std::string_view text;
  int level = 0;  ///< 1 raised, -1 lowered
};
std::vector<LabelPiece> label_pieces(std::string_view label);

inline constexpr double small_scale = 0.72;  ///< size of raised and lowered pieces
inline constexpr double raise = 0.36;        ///< of the size
inline constexpr double lower = 0.14;

/// Width of a label drawn with this font at this size [pixel].
double label_width(std::string_view label, double size);

}  // namespace assay::drivers
