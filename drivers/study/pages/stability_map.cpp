// SPDX-License-Identifier: BSD-3-Clause
// The map of which method survives where, as cells and as a picture.
#include "drivers/study/pages/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/output/html.hpp"
#include "drivers/picture/colormap.hpp"
#include "drivers/picture/label_placer.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/text/words.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t most_values = 60;  ///< of an axis that can be told apart on a map

constexpr Color pale_blue = rgb(0xe8f2fa), deep_blue = rgb(0x5a9ad6), orange = rgb(0xf6c9a0), grey = rgb(0xd9d9d9);

/// Smallest and largest error of all cases.
struct Errors {
  double low = INFINITY, high = 0;
  explicit Errors(const StudyFindings& findings) {
    for (const StudyCase& one : findings.cases) {
      if (one.budget || !one.completed() || !one.error || !(*one.error > 0)) continue;
      low = std::min(low, *one.error);
      high = std::max(high, *one.error);
    }
  }
  /// 1 for the smallest error, 0 for the largest.
  double rank(double error) const {
    if (!(high > low)) return 0.5;
    return std::clamp(std::log(high / std::max(error, low)) / std::log(high / low), 0.0, 1.0);
  }
};

bool died(const StudyCase& one) {
  return one.outcome == "unstable" || one.outcome == "material_failed" || one.outcome == "crashed";
}

/// What it says of a single case.
void tell(const StudyFindings& findings, const StudyCase& one, const Errors& errors, StabilityCell& cell) {
  if (one.completed()) {
    const double rank = one.error ? errors.rank(*one.error) : 0;
    cell.text = one.error ? error_text(findings, *one.error) : "completed";
    cell.background = mix(pale_blue, deep_blue, rank);
    cell.ink = readable_on(cell.background);
    return;
  }
  cell.text = in_plain_words(one.outcome);
  if (one.outcome != "n/a") cell.background = died(one) ? orange : grey;
  const Figure t = number_of(one, "t");
  if (died(one) && t) cell.detail = "t = " + plain_text(*t) + " s";
}

/// What it says of many.
void tell_all(const StudyFindings& findings, const Errors& errors, StabilityCell& cell) {
  std::size_t completed = 0, asked = 0;
  double high = -INFINITY;
  for (const StudyCase* one : cell.of) {
    asked += one->outcome != "n/a";
    completed += one->completed();
    if (!one->completed() || !one->error) continue;
    high = std::max(high, *one->error);
  }
  cell.text = std::to_string(completed) + " of " + std::to_string(asked);
  const bool has_error = std::isfinite(high);
  if (has_error) cell.detail = "up to " + error_text(findings, high);
  const bool some_died = std::ranges::any_of(cell.of, [](const StudyCase* one) { return died(*one); });
  if (asked > 0) cell.background = some_died ? orange : grey;
  if (completed == asked && has_error) cell.background = mix(pale_blue, deep_blue, errors.rank(high));
  cell.ink = readable_on(cell.background);
}

/// Axes whose values can be told apart on a map.
std::vector<std::string> axes_shown(const StudyFindings& findings) {
  std::vector<std::string> shown;
  for (const std::string& axis : findings.axes) {
    std::set<std::string> values;
    for (const StudyCase& one : findings.cases) values.insert(value_on(one, axis));
    if (values.size() <= most_values) shown.push_back(axis);
  }
  return shown;
}

std::string column_axis(const StudyFindings& findings, const std::vector<std::string>& shown) {
  if (is_one_of(findings.refine_key, shown)) return findings.refine_key;
  return shown.size() > 1 ? shown[1] : "";
}

/// A case's values on all axes shown but that of the columns.
std::string row_of(const StudyCase& one, const std::vector<std::string>& shown, const std::string& column) {
  std::string name;
  for (const AxisValue& at : one.values) {
    if (at.axis != column && is_one_of(at.axis, shown)) name += (name.empty() ? "" : ", ") + at.value;
  }
  return name.empty() ? "all" : name;
}

/// Where the text stands among these, or comes to stand.
std::size_t place_of(const std::string& text, std::vector<std::string>& all) {
  const std::size_t at = index_of(text, all);
  if (at == all.size()) all.push_back(text);
  return at;
}

constexpr double cell_width = 112, cell_height = 42, cell_text_size = 14, cell_small_size = 12, most_of_name = 330;

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

const StudyCase* telling_case(const StabilityCell& cell) {
  const auto lost =
      std::ranges::find_if(cell.of, [](const StudyCase* one) { return !one->completed() && one->outcome != "n/a"; });
  if (lost != cell.of.end()) return *lost;
  return cell.of.empty() ? nullptr : cell.of[0];
}

StabilityMap stability_map(const StudyFindings& findings) {
  const std::vector<std::string> shown = axes_shown(findings);
  const std::string column = column_axis(findings, shown);
  const Errors errors(findings);
  StabilityMap map{"", column, {}, {}};
  for (const std::string& axis : shown) {
    if (axis != column) map.row_name += (map.row_name.empty() ? "" : ", ") + axis;
  }
  std::vector<std::string> rows;
  for (const StudyCase& one : findings.cases) {
    if (one.budget) continue;
    const std::size_t row = place_of(row_of(one, shown, column), rows),
                      k = place_of(value_on(one, column), map.columns);
    map.rows.resize(rows.size());
    map.rows[row].name = rows[row];
    map.rows[row].cells.resize(std::max(map.rows[row].cells.size(), map.columns.size()));
    map.rows[row].cells[k].of.push_back(&one);
  }
  for (StabilityRow& row : map.rows) {
    row.cells.resize(map.columns.size());
    for (StabilityCell& cell : row.cells) {
      if (cell.of.size() == 1) tell(findings, *cell.of[0], errors, cell);
      if (cell.of.size() > 1) tell_all(findings, errors, cell);
    }
  }
  return map;
}

std::string stability_cell(const StabilityCell& cell) {
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
