// SPDX-License-Identifier: BSD-3-Clause
// Room for labels beside what they name.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "drivers/picture/drawing.hpp"

namespace assay::drivers {

struct LabelBox {
  double left = 0, top = 0, right = 0, bottom = 0;
};

bool overlap(const LabelBox& a, const LabelBox& b);

/// Whether the straight line from a to b has a point in the box.
bool crosses(Point a, Point b, const LabelBox& box);

/// Size of a label where the font of the screen is a wide one (DejaVu Sans is a quarter wider than ours).
Point roomy_size(std::string_view label, double size);

/// Puts labels down one after the other: none on another, none out of the room, rather not on lines.
class LabelPlacer {
 public:
  explicit LabelPlacer(const LabelBox& room) : room_(room) {}
  /// No label there.
  void keep_off(const LabelBox& box) { taken_.push_back(box); }
  /// Rather no label across this line.
  void avoid(std::span<const Point> line);

  struct Place {
    LabelBox box;
    Point anchor;         ///< that of the anchors beside which it stands
    double distance = 0;  ///< from there to the box
  };
  /// The best place for a box of this size beside one of the anchors, the first of them the dearest; it is taken
  /// from then on. None where there is no room within `reach` of any, or only across lines where that is not allowed.
  std::optional<Place> place(Point size, std::span<const Point> anchors, double reach = 110, bool on_lines = true);

 private:
  std::optional<double> price(const Place& place, bool on_lines) const;

  LabelBox room_;
  std::vector<LabelBox> taken_;
  std::vector<std::array<Point, 2>> lines_;
};

/// Writes a label at the best place, with a leader in its series' colour where that is not close to its anchor; does
/// nothing without a place.
void put_label(Drawing& out, LabelPlacer& placer, const std::string& text, double size, Ink ink,
               std::span<const Point> anchors, double reach, bool on_lines = true);

}  // namespace assay::drivers
