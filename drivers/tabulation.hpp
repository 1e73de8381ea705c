// SPDX-License-Identifier: BSD-3-Clause
// The tables and plots of the point driver: sheet, curve, and answers to points.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/output/points_csv.hpp"
#include "drivers/picture/line_plot.hpp"
#include "harness/response.hpp"

namespace assay::drivers {

struct Tabulation {
  Path path;
  std::shared_ptr<const Material> material;
  std::shared_ptr<const Response> response;
  double end = 0, period = 0;  ///< [s]
};

/// The path's range and the end widened to what the points ask for. Throws InputError where det F <= 0 on the way to
/// one.
void cover(const std::vector<SheetPoint>& points, const std::string& file, Tabulation& tab);

/// sheet.csv: tau and (d tau / d xi)_t on a regular grid of xi and t. Throws Interrupted when a signal came.
std::string regular_sheet(const Tabulation& tab);

/// points.csv: the same at the points, in their order.
std::string sheet_at(const Tabulation& tab, const std::vector<SheetPoint>& points);

/// tau(eps) and d tau / d eps at the time at which |g| is first largest: the curve of first loading.
struct Curve {
  std::vector<double> eps;
  std::vector<std::vector<double>> tau, slope;  ///< of each written component
};
Curve curve_of(const Tabulation& tab);

/// curve.csv.
std::string curve_csv(const Curve& curve);

/// The five components over eps. `values`: of the curve; `symbol`: what they are.
LinePlot plot_of(const Curve& curve, const std::vector<std::vector<double>>& values, const std::string& symbol,
                 const std::string& title);

/// Largest difference to the material's own closed form, relative to the largest component; none without one.
std::optional<double> difference_to_closed_form(const Tabulation& tab);

}  // namespace assay::drivers
