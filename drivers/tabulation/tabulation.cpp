// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/tabulation/tabulation.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/history/point_driver.hpp"
#include "harness/material/offer.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::drivers {

namespace {

constexpr int sheet_rows = 41;     ///< values of xi and of t in sheet.csv
constexpr int curve_points = 201;  ///< values of eps in curve.csv

/// Whether the path shears out of the plane, or the material answers with stress there.
bool leaves_the_plane(const Tabulation& tab) {
  const auto leaves = [](const Tensor& A) { return A(0, 2) != 0 || A(1, 2) != 0 || A(2, 0) != 0 || A(2, 1) != 0; };
  for (int k = 0; k < sheet_rows; ++k) {
    const double t = tab.end * k / (sheet_rows - 1);
    for (const double xi : {tab.path.parameter.lower, tab.path.parameter.upper}) {
      Tensor tau, slope;
      tab.response->at(xi, t, tau, slope);
      if (leaves(tab.path.deformation_gradient(xi, t)) || leaves(tau)) return true;
    }
  }
  return false;
}

/// Components that are written: those of the plane, or all.
std::vector<int> written_of(const Tabulation& tab) {
  if (leaves_the_plane(tab)) return {0, 1, 2, 3, 4, 5, 6, 7, 8};
  return {0, 1, 3, 4, 8};
}

void add_component_columns(const std::vector<int>& components, const std::string& slope,
                           std::vector<std::string>& names) {
  for (const int c : components) names.push_back("tau" + index_text(c));
  for (const int c : components) names.push_back("dtau" + index_text(c) + slope);
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

constexpr int rows = 17;                                  ///< of xi and of t
constexpr double shares[] = {0.0937, 0.3819, 0.7182, 1};  ///< of the way to the end of the range of xi
constexpr int times = 8;
constexpr double tolerance = 1e-12;  ///< of a step

/// xi between the two ends, in turns on both sides of zero.
std::vector<double> places(const Interval& range) {
  std::vector<double> list;
  for (const double share : shares) {
    const bool both = range.lower < 0 && range.upper > 0, down = both && list.size() % 2 == 0;
    list.push_back(down ? share * range.lower
                        : (both ? 0 : range.lower) + share * (range.upper - (both ? 0 : range.lower)));
  }
  return list;
}

/// The largest difference, over the largest value.
class Difference {
 public:
  void add(double difference, double value) {
    difference_ = larger(difference_, difference);
    scale_ = larger(scale_, value);
  }
  double relative() const { return scale_ > 0 ? difference_ / scale_ : difference_; }

 private:
  double difference_ = 0, scale_ = 0;
};

Figure difference_to_closed_form(const std::shared_ptr<const Material>& material, const Path& path,
                                 const Response& response, double end) {
  const auto form = ClosedForm::of(material, path);
  if (!form || !response.sheet()) return std::nullopt;
  Difference found;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double xi = path.parameter.lower + path.parameter.width() * i / (rows - 1), t = end * j / (rows - 1);
      Tensor tau, slope, exact, exact_slope;
      response.at(xi, t, tau, slope);
      form->at(xi, t, exact, exact_slope);
      found.add(largest_of(tau - exact), largest_of(exact));
    }
  }
  return found.relative();
}

}  // namespace

void cover(const std::vector<SheetPoint>& points, const std::string& file, Tabulation& tab) {
  for (const SheetPoint& point : points) {
    if (point.t > tab.last)
      throw InputError({file, point.line, 1}, "t", "beyond the last row of motion.path, " + rounded_text(tab.last, 6));
    if (!can_be_reached(tab.path, point))
      throw InputError({file, point.line, 1}, "xi", "det F <= 0 on the way to " + rounded_text(point.xi, 6));
    tab.path.parameter.lower = std::min(tab.path.parameter.lower, point.xi);
    tab.path.parameter.upper = std::max(tab.path.parameter.upper, point.xi);
    tab.end = std::max(tab.end, point.t);
  }
}

std::string regular_sheet(const Tabulation& tab) {
  std::vector<SheetPoint> points;
  for (int j = 0; j < sheet_rows; ++j) {
    for (int i = 0; i < sheet_rows; ++i) {
      points.push_back({tab.path.parameter.lower + tab.path.parameter.width() * i / (sheet_rows - 1),
                        tab.end * j / (sheet_rows - 1)});
    }
  }
  return sheet_at(tab, points);
}

std::string sheet_at(const Tabulation& tab, const std::vector<SheetPoint>& points) {
  const std::vector<int> written = written_of(tab);
  std::vector<std::string> names{"xi", "t", "gamma"};
  add_component_columns(written, "_dxi", names);
  CsvText csv(names);
  for (const auto& [xi, t, line] : points) {
    stop_if_interrupted();
    Tensor tau, slope;
    tab.response->at(xi, t, tau, slope);
    std::vector<double> row{xi, t, tab.path.deformation_gradient(xi, t)(1, 0)};
    for (const Tensor* of : {&tau, &slope}) {
      for (const int c : written) row.push_back(component(*of, c));
    }
    csv.row(row);
  }
  return csv.text();
}

Curve curve_of(const Tabulation& tab) {
  Curve curve{tab.path.straight(), written_of(tab), {}, {}, {}};
  curve.tau.resize(curve.components.size());
  curve.slope.resize(curve.components.size());
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
    for (std::size_t c = 0; c < curve.components.size(); ++c) {
      curve.tau[c].push_back(component(tau, curve.components[c]));
      curve.slope[c].push_back(component(slope, curve.components[c]) / g);
    }
  }
  return curve;
}

std::string curve_csv(const Curve& curve) {
  std::vector<std::string> names{curve.of_eps ? "eps" : "t"};
  add_component_columns(curve.components, curve.of_eps ? "_deps" : "_dxi", names);
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
  for (std::size_t k = 0; k < values.size(); ++k) {
    const int c = curve.components[k];  // below the diagonal, and 22, lie on another in many models
    const bool dashed = c == 3 || c == 4 || c == 6 || c == 7;
    plot.series.push_back({index_text(c), curve.x, values[k], true, false, dashed});
  }
  return plot;
}

Figure difference_of_forms(const Material& material, const Path& path, double end) {
  // a stepper without events cannot follow a rate form over its kinks
  if (!Offer<assay_rate>(material) || material.has(ASSAY_NON_SMOOTH)) return std::nullopt;
  std::vector<double> t;
  for (int k = 1; k <= times; ++k) t.push_back(end * k / times);
  DriverOptions options;
  options.tolerance = tolerance;
  const std::vector<double> xi = places(path.parameter);
  options.form = Form::rate;
  const Histories rates = integrate_histories(material, path, xi, t, options);
  stop_if_interrupted();
  options.form = Form::increments;
  const Histories increments = integrate_histories(material, path, xi, t, options);
  Difference found;
  for (std::size_t k = 0; k < t.size(); ++k) {
    for (std::size_t i = 0; i < rates.tau[k].size(); ++i)
      found.add(std::abs(rates.tau[k][i] - increments.tau[k][i]), std::abs(rates.tau[k][i]));
  }
  return found.relative();
}

ReferenceFigures references_of(const std::shared_ptr<const Material>& material, const Path& path,
                               const Response& response, double end) {
  return {difference_to_closed_form(material, path, response, end), difference_of_forms(*material, path, end)};
}

std::string references_text(const ReferenceFigures& references, const std::string& path_name) {
  std::string text;
  const auto line = [&](const char* name, const Figure& difference) {
    if (difference) {
      text += wrapped(std::string("reference: ") + name + ", largest difference " + rounded_text(*difference, 2), "  ",
                      "    ");
    }
  };
  line("the material's closed form", references.closed_form);
  line("its rate form by Boost.Odeint against its increments", references.rate_form);
  if (!text.empty()) return text;
  return wrapped("reference: none; this material offers no closed form of " + path_name + " and no smooth rate form",
                 "  ", "    ");
}

}  // namespace assay::drivers
