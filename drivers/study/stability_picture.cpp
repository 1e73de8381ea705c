// SPDX-License-Identifier: BSD-3-Clause
// The map of stability as a table of HTML and as a picture.
#include <algorithm>

#include "drivers/output/html.hpp"
#include "drivers/picture/label_placer.hpp"
#include "drivers/study/stability_map.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr double cell_width = 112, cell_height = 42, cell_text_size = 14, cell_small_size = 12, most_of_name = 330;

std::string html_cell(const StabilityCell& cell) {
  const StudyCase* one = telling_case(cell);
  if (!one) return html::element("td", html::none);
  std::string text = html::element("b", escaped(cell.text));
  if (!cell.detail.empty()) text += html::element("small", escaped(cell.detail));
  if (!one->reason.empty()) text += html::element("small", escaped(cut_text(one->reason, 70)));
  const std::string title = one->reason.empty() ? "" : "\" title=\"" + escaped(one->reason);
  return html::element("td class=\"state\" style=\"background:" + css_color(cell.background) +
                           ";color:" + css_color(cell.ink) + title + "\"",
                       text);
}

/// As much of a name as fits, with dots where it does not.
std::string fitting(const std::string& name, double size, double width) {
  for (std::size_t length = name.size(); length > 4; length -= 4) {
    std::string text = cut_text(name, length);
    if (roomy_size(text, size).x <= width) return text;
  }
  return cut_text(name, 4);
}

/// The words of a name on lines that fit, the last of so many cut.
std::vector<std::string> lines_of(const std::string& name, std::size_t most, double size, double width) {
  std::vector<std::string> lines(1);
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t blank = std::min(name.find(' ', begin), name.size());
    const std::string word = name.substr(begin, blank - begin);
    begin = blank + 1;
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || lines.size() == most || roomy_size(longer, size).x <= width) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  for (std::string& line : lines) line = fitting(line, size, width);
  return lines;
}

void draw_cell(Drawing& out, const StabilityCell& cell, double left, double top) {
  const StudyCase* one = telling_case(cell);
  if (!one) return;
  const double right = left + cell_width - 3, bottom = top + cell_height - 3, middle = (left + right) / 2;
  out.area({{left, top}, {right, top}, {right, bottom}, {left, bottom}}, {Ink::Role::fixed, 0, cell.background});
  out.tip(one->label + ": " + outcome_text(*one) + (one->reason.empty() ? "" : ". " + one->reason));
  const Ink ink{Ink::Role::fixed, 0, cell.ink};
  const bool two = !cell.detail.empty();
  const double size = cell.text.size() > 10 ? cell_small_size : cell_text_size;
  out.label({middle, top + (two ? 17 : 24.5)}, fitting(cell.text, size, cell_width - 6), size, Anchor::middle, ink);
  const std::string detail = fitting(cell.detail, cell_small_size, cell_width - 6);
  if (two) out.label({middle, top + 32}, detail, cell_small_size, Anchor::middle, ink);
}

}  // namespace

std::string stability_table(const StabilityMap& map) {
  std::vector<std::string> head{escaped(map.row_name)};
  for (const std::string& column : map.columns) {
    head.push_back(escaped(map.column_name.empty() ? column : map.column_name + " = " + column));
  }
  std::vector<std::vector<std::string>> rows;
  for (const StabilityRow& row : map.rows) {
    rows.push_back({escaped(row.name)});
    for (const StabilityCell& cell : row.cells) rows.back().push_back(html_cell(cell));
  }
  return html::table(head, rows);
}

Drawing stability_picture(const StabilityMap& map) {
  constexpr std::size_t head_lines = 3;
  constexpr double line = 17;
  std::vector<std::vector<std::string>> heads;
  std::size_t deepest = 1;
  for (const std::string& column : map.columns) {
    heads.push_back(lines_of(column, head_lines, cell_text_size, cell_width - 4));
    deepest = std::max(deepest, heads.back().size());
  }
  const double head = 39 + line * static_cast<double>(deepest);
  double names = 60;
  for (const StabilityRow& row : map.rows) names = std::max(names, roomy_size(row.name, cell_text_size).x);
  names = std::min(names, most_of_name) + 16;
  Drawing out{names + cell_width * static_cast<double>(std::max<std::size_t>(map.columns.size(), 3)) + 8,
              head + cell_height * static_cast<double>(map.rows.size()) + 8,
              "what completes and what does not",
              {}};
  out.label({names, 18}, map.column_name, cell_text_size, Anchor::left);
  for (std::size_t k = 0; k < map.columns.size(); ++k) {
    const double middle = names + cell_width * (static_cast<double>(k) + 0.5) - 1.5;
    for (std::size_t l = 0; l < heads[k].size(); ++l) {
      const double above = line * static_cast<double>(heads[k].size() - 1 - l);
      out.label({middle, head - 12 - above}, heads[k][l], cell_text_size, Anchor::middle);
    }
  }
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    const double top = head + cell_height * static_cast<double>(i);
    out.label({names - 10, top + 25}, fitting(map.rows[i].name, cell_text_size, names - 14), cell_text_size,
              Anchor::right);
    for (std::size_t k = 0; k < map.columns.size(); ++k) {
      draw_cell(out, map.rows[i].cells[k], names + cell_width * static_cast<double>(k), top);
    }
  }
  return out;
}

}  // namespace assay::drivers
