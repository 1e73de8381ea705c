// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/label_placer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/picture/stroke_font.hpp"

namespace assay::drivers {

namespace {

constexpr double margin = 2;          // between labels
constexpr double dear_crossing = 70;  // a line through a label is worth this way
constexpr double later_anchor = 2;    // an anchor is worth this more than the next
constexpr double close_by = 12;       // no leader is needed
constexpr int directions = 24;

LabelBox grown(const LabelBox& box, double by) {
  return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

/// The box of this size that lies `distance` off the anchor in a direction.
LabelBox beside(Point anchor, Point size, double distance, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double x = anchor.x + c * distance + std::clamp(1.6 * c, -1.0, 1.0) * size.x / 2;
  const double y = anchor.y + s * distance + std::clamp(1.6 * s, -1.0, 1.0) * size.y / 2;
  return {x - size.x / 2, y - size.y / 2, x + size.x / 2, y + size.y / 2};
}

/// Where a leader from the anchor meets the box.
Point nearest_point(const LabelBox& box, Point to) {
  return {std::clamp(to.x, box.left, box.right), std::clamp(to.y, box.top, box.bottom)};
}

double distance_of(const LabelBox& box, Point from) {
  const Point to = nearest_point(box, from);
  return std::hypot(to.x - from.x, to.y - from.y);
}

}  // namespace

bool overlap(const LabelBox& a, const LabelBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

bool crosses(Point a, Point b, const LabelBox& box) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double one = (low - start) / step, other = (high - start) / step;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return from <= to;
  };
  return cut(a.x, b.x - a.x, box.left, box.right) && cut(a.y, b.y - a.y, box.top, box.bottom);
}

Point roomy_size(std::string_view label, double size) { return {1.25 * label_width(label, size), 1.25 * size}; }

void LabelPlacer::avoid(std::span<const Point> line) {
  for (std::size_t i = 1; i < line.size(); ++i) lines_.push_back({line[i - 1], line[i]});
}

/// None where the label may not stand.
std::optional<double> LabelPlacer::price(const Place& place, bool on_lines) const {
  const LabelBox& box = place.box;
  if (box.left < room_.left || box.right > room_.right || box.top < room_.top || box.bottom > room_.bottom) return {};
  const Point end = nearest_point(box, place.anchor);
  for (const LabelBox& other : taken_) {
    if (overlap(grown(box, margin), other)) return {};
    if (place.distance > close_by && crosses(place.anchor, end, grown(other, -1))) return {};
  }
  double price = place.distance;
  for (const auto& [a, b] : lines_) {
    if (!crosses(a, b, grown(box, margin))) continue;
    if (!on_lines) return {};
    price += dear_crossing;
  }
  return price;
}

std::optional<LabelPlacer::Place> LabelPlacer::place(Point size, std::span<const Point> anchors, double reach,
                                                     bool on_lines) {
  std::optional<Place> best;
  double lowest = 0;
  for (std::size_t k = 0; k < anchors.size(); ++k) {
    for (double distance = 8; distance <= reach; distance *= 1.18) {
      for (int i = 0; i < directions; ++i) {
        Place one{beside(anchors[k], size, distance, 2 * std::numbers::pi * i / directions), anchors[k], 0};
        one.distance = distance_of(one.box, anchors[k]);
        const std::optional<double> found = price(one, on_lines);
        if (!found || (best && *found + later_anchor * static_cast<double>(k) >= lowest)) continue;
        best = one;
        lowest = *found + later_anchor * static_cast<double>(k);
      }
    }
  }
  if (!best) return best;
  keep_off(best->box);
  const std::array<Point, 2> leader{best->anchor, nearest_point(best->box, best->anchor)};
  if (best->distance > close_by) avoid(leader);
  return best;
}

void put_label(Drawing& out, LabelPlacer& placer, const std::string& text, double size, Ink ink,
               std::span<const Point> anchors, double reach, bool on_lines) {
  constexpr double off_marker = 7, off_baseline = 0.31;
  const auto place = placer.place(roomy_size(text, size), anchors, reach, on_lines);
  if (!place) return;
  const LabelBox& box = place->box;
  const Point from = place->anchor;
  if (place->distance > close_by) {
    const Point end = nearest_point(box, from);
    const double part = off_marker / place->distance;
    const Ink leader = ink.role == Ink::Role::name ? Ink{Ink::Role::series, ink.series} : Ink{Ink::Role::axis};
    out.line({{from.x + part * (end.x - from.x), from.y + part * (end.y - from.y)}, end}, leader, 1);
  }
  const double y = box.bottom - off_baseline * size;
  if (box.left >= from.x) {
    out.label({box.left, y}, text, size, Anchor::left, ink);
  } else if (box.right <= from.x) {
    out.label({box.right, y}, text, size, Anchor::right, ink);
  } else {
    out.label({(box.left + box.right) / 2, y}, text, size, Anchor::middle, ink);
  }
}

}  // namespace assay::drivers
