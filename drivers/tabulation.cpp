// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/tabulation.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/input_error.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/output/csv.hpp"
#include "drivers/output/number_format.hpp"

namespace assay::drivers {

namespace {

constexpr int sheet_rows = 41;              ///< values of xi and of t in sheet.csv
constexpr int curve_points = 201;           ///< values of eps in curve.csv
constexpr int written[] = {0, 1, 3, 4, 8};  ///< components 11, 12, 21, 22, 33

std::vector<std::string> component_columns(const std::string& before, const std::string& after) {
  std::vector<std::string> names;
  for (const char* c : {"11", "12", "21", "22", "33"}) names.push_back(before + c + after);
  return names;
}

CsvText sheet_table() {
  std::vector<std::string> names{"xi", "t", "gamma"};
  for (const auto& list : {component_columns("tau", ""), component_columns("dtau", "_dxi")}) {
    names.insert(names.end(), list.begin(), list.end());
  }
  return CsvText(names);
}

void add_row(const Tabulation& tab, double xi, double t, CsvText& csv) {
  stop_if_interrupted();
  Tensor tau, slope;
  tab.response->at(xi, t, tau, slope);
  std::vector<double> row{xi, t, tab.path.deformation_gradient(xi, t)(1, 0)};
  for (const int c : written) row.push_back(component(tau, c));
  for (const int c : written) row.push_back(component(slope, c));
  csv.row(row);
}

/// The time at which |g| is first largest: there tau(xi, t) against eps = xi g is the curve of first loading.
double time_of_first_peak(const Path& path, double end, double period) {
  end = std::min(end, 2 * period);
  std::vector<double> times = path.reversals(end);
  times.push_back(end);
  double best = times.front();
  for (const double t : times) {
    if (std::abs(path.amplitude(t)) > (1 + 1e-12) * std::abs(path.amplitude(best))) best = t;
  }
  return best;
}

/// Whether det F > 0 all the way from the reference state to the point.
bool can_be_reached(const Path& path, const SheetPoint& point) {
  constexpr int steps = 64;
  for (int k = 1; k <= steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const Tensor F = path.straight() ? Tensor::Identity() + share * path.eps(point.xi, point.t) * path.direction
                                     : path.deformation_gradient(point.xi, share * point.t);
    if (!(F.determinant() > 0)) return false;
  }
  return true;
}

}  // namespace

void cover(const std::vector<SheetPoint>& points, const std::string& file, Tabulation& tab) {
  for (const SheetPoint& point : points) {
    if (point.t > tab.last) {
      throw InputError({file, point.line, 1}, "t", "beyond the last row of motion.path, " + rounded_text(tab.last, 6));
    }
    if (!can_be_reached(tab.path, point)) {
      throw InputError({file, point.line, 1}, "xi", "det F <= 0 on the way to " + rounded_text(point.xi, 6));
    }
    tab.path.parameter.lower = std::min(tab.path.parameter.lower, point.xi);
    tab.path.parameter.upper = std::max(tab.path.parameter.upper, point.xi);
    tab.end = std::max(tab.end, point.t);
  }
}

std::string regular_sheet(const Tabulation& tab) {
  CsvText csv = sheet_table();
  for (int j = 0; j < sheet_rows; ++j) {
    for (int i = 0; i < sheet_rows; ++i) {
      add_row(tab, tab.path.parameter.lower + tab.path.parameter.width() * i / (sheet_rows - 1),
              tab.end * j / (sheet_rows - 1), csv);
    }
  }
  return csv.text();
}

std::string sheet_at(const Tabulation& tab, const std::vector<SheetPoint>& points) {
  CsvText csv = sheet_table();
  for (const SheetPoint& point : points) add_row(tab, point.xi, point.t, csv);
  return csv.text();
}

Curve curve_of(const Tabulation& tab) {
  Curve curve{tab.path.straight(), {}, std::vector<std::vector<double>>(5), std::vector<std::vector<double>>(5)};
  const double peak = curve.of_eps ? time_of_first_peak(tab.path, tab.end, tab.period) : 0;
  const double g = curve.of_eps ? tab.path.amplitude(peak) : 1;
  for (int i = 0; i < curve_points; ++i) {
    const double share = static_cast<double>(i) / (curve_points - 1);
    const double xi =
        curve.of_eps ? tab.path.parameter.lower + tab.path.parameter.width() * share : tab.path.parameter.upper;
    const double t = curve.of_eps ? peak : tab.end * share;
    Tensor tau, slope;
    tab.response->at(xi, t, tau, slope);
    curve.x.push_back(curve.of_eps ? xi * g : t);
    for (std::size_t c = 0; c < 5; ++c) {
      curve.tau[c].push_back(component(tau, written[c]));
      curve.slope[c].push_back(component(slope, written[c]) / g);
    }
  }
  return curve;
}

std::string curve_csv(const Curve& curve) {
  std::vector<std::string> names{curve.of_eps ? "eps" : "t"};
  for (const auto& list : {component_columns("tau", ""), component_columns("dtau", curve.of_eps ? "_deps" : "_dxi")}) {
    names.insert(names.end(), list.begin(), list.end());
  }
  CsvText csv(names);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    std::vector<double> row{curve.x[i]};
    for (const auto* group : {&curve.tau, &curve.slope}) {
      for (const auto& values : *group) row.push_back(values[i]);
    }
    csv.row(row);
  }
  return csv.text();
}

LinePlot plot_of(const Curve& curve, const std::vector<std::vector<double>>& values, const std::string& symbol,
                 const std::string& title) {
  LinePlot plot;
  plot.title = title;
  plot.x_label = curve.of_eps ? "ε [1]" : "t [s]";
  plot.y_label = symbol + " [Pa]";
  const char* names[] = {"11", "12", "21", "22", "33"};
  for (std::size_t c = 0; c < 5; ++c) {
    plot.series.push_back({names[c], curve.x, values[c], true, false,
                           c == 2 || c == 3});  // 12 = 21 and 11 = 22 lie on another in many models
  }
  return plot;
}

}  // namespace assay::drivers
