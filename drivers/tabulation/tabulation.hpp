// SPDX-License-Identifier: BSD-3-Clause
// The tables and plots of the point driver: sheet, curve, and answers to points.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "drivers/output/points_csv.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/result/result.hpp"
#include "harness/exact/response.hpp"

namespace assay::drivers {

struct Tabulation {
  Path path;
  std::shared_ptr<const Material> material;
  std::shared_ptr<const Response> response;
  double end = 0, period = 0;                             ///< [s]
  double last = std::numeric_limits<double>::infinity();  ///< time at which the path ends [s]
};

/// "12": of a component, row-major.
inline std::string index_text(int c) { return std::to_string(c / 3 + 1) + std::to_string(c % 3 + 1); }

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

/// A component of tau, 12 in simple shear, else the one that becomes largest over the sheet: over t and xi, lines where
/// its slope in xi jumps (the fronts of a material with kinks), dashes where the path turns.
HeatMap sheet_picture(const Tabulation& tab);

/// That component along four histories xi: over gamma in simple shear, over eps on another straight path, else over t.
LinePlot histories_plot(const Tabulation& tab);

// What the response is compared with: whatever of the material does not come from the same equations.

/// Largest difference between tau by the material's rate form and by its increments, relative to the largest
/// component, at 4 values of xi and 8 times; none without a rate form, or where the material has kinks. Throws
/// MaterialFailure.
Figure difference_of_forms(const Material& material, const Path& path, double end);

/// That, and the largest difference of the tabulated tau to the material's closed form of the path, relative to its
/// largest component, at 17 x 17 regular xi and t; none without one.
ReferenceFigures references_of(const std::shared_ptr<const Material>& material, const Path& path,
                               const Response& response, double end);

/// One line each, or one that says that there is none.
std::string references_text(const ReferenceFigures& references, const std::string& path_name);

}  // namespace assay::drivers
