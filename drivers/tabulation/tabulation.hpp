// SPDX-License-Identifier: BSD-3-Clause
// The tables and plots of the point driver: sheet, curve, and answers to points.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/output/points_csv.hpp"
#include "drivers/picture/line_plot.hpp"
#include "harness/exact/response.hpp"

namespace assay::drivers {

struct Tabulation {
  Path path;
  std::shared_ptr<const Material> material;
  std::shared_ptr<const Response> response;
  double end = 0, period = 0;                             ///< [s]
  double last = std::numeric_limits<double>::infinity();  ///< time at which the path ends [s]
};

/// The path's range and the end widened to what the points ask for. Throws InputError where det F <= 0 on the way to
/// one, or where the path ends before it.
void cover(const std::vector<SheetPoint>& points, const std::string& file, Tabulation& tab);

/// sheet.csv: tau and (d tau / d xi)_t on a regular grid of xi and t. Throws Interrupted when a signal came.
std::string regular_sheet(const Tabulation& tab);

/// points.csv: the same at the points, in their order.
std::string sheet_at(const Tabulation& tab, const std::vector<SheetPoint>& points);

/// tau and its slope along a line of the sheet: on a straight path over eps at the time at which |g| is first largest,
/// the curve of first loading, with d tau / d eps; else the history of the largest xi over t, with (d tau / d xi)_t.
struct Curve {
  bool of_eps = true;
  std::vector<int> components;  ///< 0 .. 8, row-major: those of the plane, all where the path leaves it
  std::vector<double> x;
  std::vector<std::vector<double>> tau, slope;  ///< of each of them
};
Curve curve_of(const Tabulation& tab);

/// curve.csv of a curve over eps, history.csv of one over t.
std::string curve_csv(const Curve& curve);

/// `values`: of the curve; `symbol`: what they are.
LinePlot plot_of(const Curve& curve, const std::vector<std::vector<double>>& values, const std::string& symbol,
                 const std::string& title);

}  // namespace assay::drivers
