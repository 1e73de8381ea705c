// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "drivers/picture/colormap.hpp"
#include "drivers/picture/stroke_font.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

std::string number(double value) { return rounded_text(std::round(value * 100) / 100, 8); }

/// How a role is drawn: the opacity of the page's own colour, and the colour on white paper. Series, their names and
/// fixed colours have their own.
struct RoleStyle {
  Ink::Role role;
  std::uint32_t print;
  const char* opacity;
};
constexpr RoleStyle role_styles[] = {{Ink::Role::text, 0x1a1a1a, ""},
                                     {Ink::Role::axis, 0x4d4d4d, ".7"},
                                     {Ink::Role::grid, 0xdedede, ".16"},
                                     {Ink::Role::faint, 0xa4a4a4, ".4"},
                                     {Ink::Role::band, 0xcdcdcd, ".22"}};

const RoleStyle* style_of(Ink ink) {
  const auto* found = std::find_if(std::begin(role_styles), std::end(role_styles),
                                   [&](const RoleStyle& style) { return style.role == ink.role; });
  return found == std::end(role_styles) ? nullptr : found;
}

Color print_color(Ink ink) {
  if (const RoleStyle* style = style_of(ink)) return rgb(style->print);
  return ink.role == Ink::Role::series ? series_color(ink.series)
         : ink.role == Ink::Role::name ? series_text_color(ink.series)
                                       : ink.color;
}

std::string css(Ink ink) {
  if (style_of(ink)) return "currentColor";
  std::string color = css_color(print_color(ink));
  if (ink.role == Ink::Role::fixed) return color;
  const char* variable = ink.role == Ink::Role::series ? "var(--series-" : "var(--name-";
  return variable + std::to_string(ink.series % 7) + "," + color + ")";
}

std::string opacity(Ink ink, const char* property) {
  const RoleStyle* style = style_of(ink);
  return style && *style->opacity ? std::string(";") + property + ":" + style->opacity : "";
}

std::string path_of(const DrawingItem& item) {
  std::string out;
  for (std::size_t i = 0; i < item.points.size(); ++i) {
    out += (i == 0 ? "M" : "L") + number(item.points[i].x) + " " + number(item.points[i].y);
  }
  return out;
}

/// The end of an element.
std::string closed(const DrawingItem& item, const char* tag) {
  if (item.tip.empty()) return "/>\n";
  return "><title>" + escaped(item.tip) + "</title></" + tag + ">\n";
}

std::string line_svg(const DrawingItem& item) {
  std::string out = "<path d=\"" + path_of(item) + "\" style=\"fill:none;stroke:" + css(item.ink) +
                    opacity(item.ink, "stroke-opacity") + ";stroke-width:" + number(item.size) +
                    ";stroke-linejoin:round;stroke-linecap:round";
  if (item.dash > 0) out += ";stroke-dasharray:" + number(item.dash);
  return out + "\"" + closed(item, "path");
}

std::string filled(const DrawingItem& item, const char* tag) {
  return "\" style=\"fill:" + css(item.ink) + opacity(item.ink, "fill-opacity") + "\"" + closed(item, tag);
}

std::string area_svg(const DrawingItem& item) { return "<path d=\"" + path_of(item) + "Z" + filled(item, "path"); }

std::string disc_svg(const DrawingItem& item) {
  return "<circle cx=\"" + number(item.points[0].x) + "\" cy=\"" + number(item.points[0].y) + "\" r=\"" +
         number(item.size) + filled(item, "circle");
}

std::string label_svg(const DrawingItem& item) {
  const std::string x = number(item.points[0].x), y = number(item.points[0].y);
  const char* anchor = item.anchor == Anchor::left ? "start" : item.anchor == Anchor::middle ? "middle" : "end";
  std::string out = "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + number(item.size) + "\" text-anchor=\"" +
                    anchor + "\"" + (item.upwards ? " transform=\"rotate(-90 " + x + " " + y + ")\"" : "") +
                    " style=\"fill:" + css(item.ink) + "\">";
  double risen = 0;  // dy is relative to what came before
  for (const LabelPiece& piece : label_pieces(item.label)) {
    const double rise = piece.level > 0 ? raise * item.size : piece.level < 0 ? -lower * item.size : 0;
    if (piece.level == 0 && rise == risen) {
      out += escaped(piece.text);
      continue;
    }
    out += "<tspan dy=\"" + number(risen - rise) + "\"";
    if (piece.level != 0) out += " font-size=\"" + number(small_scale * item.size) + "\"";
    out += ">" + escaped(piece.text) + "</tspan>";
    risen = rise;
  }
  return out + "</text>\n";
}

}  // namespace

std::string css_color(Color color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b}) {
    out += digits[part >> 4];
    out += digits[part & 15];
  }
  return out;
}

void Drawing::line(std::vector<Point> points, Ink ink, double line_width, double dash) {
  items.push_back({DrawingItem::Kind::line, ink, std::move(points), line_width, dash});
}

void Drawing::disc(Point center, double radius, Ink ink) {
  items.push_back({DrawingItem::Kind::disc, ink, {center}, radius});
}

void Drawing::label(Point at, std::string text, double size, Anchor anchor, Ink ink, bool upwards) {
  items.push_back({DrawingItem::Kind::label, ink, {at}, size, 0, std::move(text), anchor, upwards});
}

void Drawing::area(std::vector<Point> around, Ink ink) {
  items.push_back({DrawingItem::Kind::area, ink, std::move(around)});
}

void Drawing::tip(std::string text) { items.back().tip = std::move(text); }

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : utf8(text)) {  // a model's words may be anything
    const char* entity = c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : nullptr;
    // Control characters are not allowed in XML, not even escaped.
    const bool allowed = static_cast<unsigned char>(c) >= 32 || c == '\n' || c == '\t';
    if (entity)
      out += entity;
    else
      out += allowed ? c : ' ';
  }
  return out;
}

std::string svg_text(const Drawing& drawing) {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(drawing.width) + " " +
                    number(drawing.height) + "\" role=\"img\" font-family=\"system-ui,sans-serif\">\n";
  if (!drawing.title.empty()) out += "<title>" + escaped(drawing.title) + "</title>\n";
  for (const DrawingItem& item : drawing.items) {
    out += item.kind == DrawingItem::Kind::line   ? line_svg(item)
           : item.kind == DrawingItem::Kind::disc ? disc_svg(item)
           : item.kind == DrawingItem::Kind::area ? area_svg(item)
                                                  : label_svg(item);
  }
  return out + "</svg>\n";
}

Canvas raster(const Drawing& drawing, double scale) {
  Canvas canvas(static_cast<int>(std::lround(drawing.width * scale)),
                static_cast<int>(std::lround(drawing.height * scale)), rgb(0xffffff));
  for (const DrawingItem& item : drawing.items) {
    std::vector<Point> points;
    for (const Point p : item.points) points.push_back({p.x * scale, p.y * scale});
    const Color color = print_color(item.ink);
    if (item.kind == DrawingItem::Kind::line) {
      canvas.stroke(points, item.size * scale, color, item.dash * scale);
    } else if (item.kind == DrawingItem::Kind::disc) {
      canvas.circle(points[0], item.size * scale, color);
    } else if (item.kind == DrawingItem::Kind::area) {
      canvas.fill(points, color);
    } else {
      canvas.text(points[0], item.label, {item.size * scale, color, item.anchor, item.upwards});
    }
  }
  return canvas;
}

}  // namespace assay::drivers
