// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/stability_map.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "drivers/picture/colormap.hpp"
#include "drivers/study/study_words.hpp"

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
  cell.text = one.outcome;
  std::replace(cell.text.begin(), cell.text.end(), '_', ' ');
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
  const bool some_died = std::any_of(cell.of.begin(), cell.of.end(), [](const StudyCase* one) { return died(*one); });
  if (asked > 0) cell.background = some_died ? orange : grey;
  if (completed == asked && has_error) cell.background = mix(pale_blue, deep_blue, errors.rank(high));
  cell.ink = readable_on(cell.background);
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
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
  if (is_among(shown, findings.refine_key)) return findings.refine_key;
  return shown.size() > 1 ? shown[1] : "";
}

/// A case's values on all axes shown but that of the columns.
std::string row_of(const StudyCase& one, const std::vector<std::string>& shown, const std::string& column) {
  std::string name;
  for (const AxisValue& at : one.values) {
    if (at.axis != column && is_among(shown, at.axis)) name += (name.empty() ? "" : ", ") + at.value;
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

const StudyCase* telling_case(const StabilityCell& cell) {
  const auto lost = std::find_if(cell.of.begin(), cell.of.end(),
                                 [](const StudyCase* one) { return !one->completed() && one->outcome != "n/a"; });
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

}  // namespace assay::drivers
