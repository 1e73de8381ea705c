// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/stability_map.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/picture/colormap.hpp"
#include "drivers/study/study_words.hpp"

namespace assay::drivers {

namespace {

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

StabilityCell cell_of(const StudyFindings& findings, const StudyCase& one, const Errors& errors) {
  StabilityCell cell;
  cell.of = &one;
  if (one.completed()) {
    const double rank = one.error ? errors.rank(*one.error) : 0;
    cell.text = one.error ? error_text(findings, *one.error) : "completed";
    cell.background = mix(pale_blue, deep_blue, rank);
    cell.ink = readable_on(cell.background);
    return cell;
  }
  cell.text = one.outcome;
  std::replace(cell.text.begin(), cell.text.end(), '_', ' ');
  const bool died = one.outcome == "unstable" || one.outcome == "material_failed" || one.outcome == "crashed";
  if (one.outcome != "n/a") cell.background = died ? orange : grey;
  const Figure t = number_of(one, "t");
  if (died && t) cell.detail = "t = " + plain_text(*t) + " s";
  return cell;
}

bool is_axis(const StudyFindings& findings, const std::string& name) {
  return std::find(findings.axes.begin(), findings.axes.end(), name) != findings.axes.end();
}

std::string column_axis(const StudyFindings& findings) {
  if (is_axis(findings, findings.refine_key)) return findings.refine_key;
  return findings.axes.size() > 1 ? findings.axes[1] : "";
}

/// A case's values on all axes but that of the columns.
std::string row_of(const StudyCase& one, const std::string& column) {
  std::string name;
  for (const AxisValue& at : one.values) {
    if (at.axis != column) name += (name.empty() ? "" : ", ") + at.value;
  }
  return name.empty() ? "all" : name;
}

/// Where the text stands among these, or comes to stand.
std::size_t place_of(const std::string& text, std::vector<std::string>& all) {
  const auto found = std::find(all.begin(), all.end(), text);
  const auto at = static_cast<std::size_t>(found - all.begin());
  if (found == all.end()) all.push_back(text);
  return at;
}

}  // namespace

StabilityMap stability_map(const StudyFindings& findings) {
  const std::string column = column_axis(findings);
  const Errors errors(findings);
  StabilityMap map{"", column, {}, {}};
  for (const std::string& axis : findings.axes) {
    if (axis != column) map.row_name += (map.row_name.empty() ? "" : ", ") + axis;
  }
  std::vector<std::string> rows;
  for (const StudyCase& one : findings.cases) {
    if (one.budget) continue;
    const std::size_t row = place_of(row_of(one, column), rows), k = place_of(value_on(one, column), map.columns);
    map.rows.resize(rows.size());
    map.rows[row].name = rows[row];
    map.rows[row].cells.resize(std::max(map.rows[row].cells.size(), map.columns.size()));
    map.rows[row].cells[k] = cell_of(findings, one, errors);
  }
  for (StabilityRow& row : map.rows) row.cells.resize(map.columns.size());
  return map;
}

}  // namespace assay::drivers
