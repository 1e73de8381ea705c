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

/// Whether det F > 0 all the way from the reference state to eps.
bool can_be_reached(double eps, const Tensor& direction) {
  constexpr int steps = 64;
  for (int k = 1; k <= steps; ++k) {
    if (!((Tensor::Identity() + eps * k / steps * direction).determinant() > 0)) return false;
  }
  return true;
}

}  // namespace

void cover(const std::vector<SheetPoint>& points, const std::string& file, Tabulation& tab) {
  for (const SheetPoint& point : points) {
    if (!can_be_reached(tab.path.eps(point.xi, point.t), tab.path.direction)) {
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
  Curve curve{{}, std::vector<std::vector<double>>(5), std::vector<std::vector<double>>(5)};
  const double t = time_of_first_peak(tab.path, tab.end, tab.period), g = tab.path.amplitude(t);
  for (int i = 0; i < curve_points; ++i) {
    const double xi = tab.path.parameter.lower + tab.path.parameter.width() * i / (curve_points - 1);
    Tensor tau, slope;
    tab.response->at(xi, t, tau, slope);
    curve.eps.push_back(xi * g);
    for (std::size_t c = 0; c < 5; ++c) {
      curve.tau[c].push_back(component(tau, written[c]));
      curve.slope[c].push_back(component(slope, written[c]) / g);
    }
  }
  return curve;
}

std::string curve_csv(const Curve& curve) {
  std::vector<std::string> names{"eps"};
  for (const auto& list : {component_columns("tau", ""), component_columns("dtau", "_deps")}) {
    names.insert(names.end(), list.begin(), list.end());
  }
  CsvText csv(names);
  for (std::size_t i = 0; i < curve.eps.size(); ++i) {
    std::vector<double> row{curve.eps[i]};
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
  plot.x_label = "ε [1]";
  plot.y_label = symbol + " [Pa]";
  const char* names[] = {"11", "12", "21", "22", "33"};
  for (std::size_t c = 0; c < 5; ++c) {
    plot.series.push_back({names[c], curve.eps, values[c], true, false,
                           c == 2 || c == 3});  // 12 = 21 and 11 = 22 lie on another in many models
  }
  return plot;
}

std::optional<double> difference_to_closed_form(const Tabulation& tab) {
  const auto form = ClosedForm::of(tab.material, tab.path);
  if (!form || !tab.response->sheet()) return std::nullopt;
  double difference = 0, scale = 0;
  for (int i = 0; i < sheet_rows; ++i) {
    for (int j = 0; j < sheet_rows; ++j) {
      const double xi = tab.path.parameter.lower + tab.path.parameter.width() * i / (sheet_rows - 1);
      const double t = tab.end * j / (sheet_rows - 1);
      Tensor tau, slope, exact, exact_slope;
      tab.response->at(xi, t, tau, slope);
      form->at(xi, t, exact, exact_slope);
      difference = std::max(difference, (tau - exact).cwiseAbs().maxCoeff());
      scale = std::max(scale, exact.cwiseAbs().maxCoeff());
    }
  }
  return scale > 0 ? difference / scale : difference;
}

}  // namespace assay::drivers
