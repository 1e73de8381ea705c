// SPDX-License-Identifier: BSD-3-Clause
// The response as pictures.
#include <algorithm>
#include <cmath>

#include "drivers/system/interrupt.hpp"
#include "drivers/tabulation/tabulation.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t map_columns = 350, map_rows = 240;  ///< of the picture: two pixels a cell
constexpr int look = 24;                                  ///< values of xi and of t for the largest component
constexpr int history_points = 600;
constexpr std::size_t front_times = 1400;   ///< at which fronts are looked for
constexpr double reach = 0.05;              ///< of the range of xi: how far a front may go from one to the next
constexpr double beside = 1e-6;             ///< of the range of xi: where the slopes on both sides of a front are taken
constexpr double least_jump = 1e-3;         ///< of the slope: less is the edge of a patch, not a front
constexpr std::size_t most_reversals = 12;  ///< that are drawn: a table has one at every row

double xi_at(const Tabulation& tab, double share) {
  return tab.path.parameter.lower + share * tab.path.parameter.width();
}

/// Fronts of neighbouring columns joined to lines; a front without a neighbour is a short dash.
class FrontLines {
 public:
  FrontLines(double step, double farthest) : step_(step), farthest_(farthest) {}

  void add(double t, const std::vector<double>& fronts) {
    std::vector<std::vector<Point>> going;
    for (const double xi : fronts) {
      const auto near = std::min_element(going_.begin(), going_.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.back().y - xi) < std::abs(b.back().y - xi);
      });
      if (near != going_.end() && std::abs(near->back().y - xi) <= farthest_) {
        near->push_back({t, xi});
        going.push_back(std::move(*near));
        going_.erase(near);
      } else {
        going.push_back({{t - step_ / 2, xi}, {t, xi}});
      }
    }
    finish();
    going_ = std::move(going);
  }

  std::vector<std::vector<Point>> lines() {
    finish();
    return std::move(done_);
  }

 private:
  void finish() {
    for (auto& line : going_) done_.push_back(std::move(line));
    going_.clear();
  }
  double step_, farthest_;
  std::vector<std::vector<Point>> going_, done_;
};

/// The fronts at which the slope jumps at this time.
std::vector<double> jumps(const Tabulation& tab, double t) {
  std::vector<double> found;
  const double step = beside * tab.path.parameter.width();
  const auto now = tab.response->at_time(t);
  Tensor tau, below, above;
  for (const double xi : now->fronts()) {
    now->at(xi - step, tau, below);
    now->at(xi + step, tau, above);
    if ((above - below).norm() > least_jump * std::max(above.norm(), below.norm())) found.push_back(xi);
  }
  return found;
}

/// Of tau, row-major.
int shown_component(const Tabulation& tab) {
  if (tab.path.name == "simple_shear") return 1;
  double largest[9] = {};
  for (int i = 0; i <= look; ++i) {
    for (int j = 1; j <= look; ++j) {
      Tensor tau, slope;
      tab.response->at(xi_at(tab, double(i) / look), tab.end * j / look, tau, slope);
      for (int c = 0; c < 9; ++c) largest[c] = std::max(largest[c], std::abs(component(tau, c)));
    }
  }
  // one that is larger by rounding alone is not larger
  int best = 0;
  for (int c = 1; c < 9; ++c) {
    if (largest[c] > 1.001 * largest[best]) best = c;
  }
  return best;
}

}  // namespace

HeatMap sheet_picture(const Tabulation& tab) {
  const int shown = shown_component(tab);
  HeatMap map;
  map.title = "τ_{" + index_text(shown) + "}(ξ, t): " + tab.material->name() + ", " + tab.path.name;
  map.x_label = "t [s]";
  map.y_label = "ξ [1]";
  map.value_label = "τ_{" + index_text(shown) + "} [Pa]";
  map.x = {0, tab.end};
  map.y = {tab.path.parameter.lower, tab.path.parameter.upper};
  if (!(map.y[1] > map.y[0])) map.y[1] = map.y[0] + 1e-9;
  map.columns = map_columns;
  map.rows = map_rows;
  map.values.resize(map_columns * map_rows);
  std::vector<double> xi;
  for (std::size_t j = 0; j < map_rows; ++j) xi.push_back(xi_at(tab, (double(j) + 0.5) / double(map_rows)));
  for (std::size_t i = 0; i < map_columns; ++i) {
    stop_if_interrupted();
    const double t = tab.end * (double(i) + 0.5) / double(map_columns);
    const auto now = tab.response->at_time(t);
    Tensor tau, slope;
    for (std::size_t j = 0; j < xi.size(); ++j) {
      now->at(xi[j], tau, slope);
      map.values[i * map_rows + j] = component(tau, shown);
    }
  }
  FrontLines fronts(tab.end / double(front_times), reach * tab.path.parameter.width());
  for (std::size_t i = 0; i < front_times; ++i) {
    const double t = tab.end * (double(i) + 0.5) / double(front_times);
    fronts.add(t, jumps(tab, t));
  }
  map.lines = fronts.lines();
  const std::vector<double> turns = tab.path.reversals(tab.end);
  for (std::size_t k = 0; k < turns.size() && turns.size() <= most_reversals; ++k)
    map.dashes.push_back({{turns[k], map.y[0]}, {turns[k], map.y[1]}});
  return map;
}

LinePlot histories_plot(const Tabulation& tab) {
  const int shown = shown_component(tab);
  const Interval range = tab.path.parameter;
  const bool shear = tab.path.name == "simple_shear", straight = tab.path.straight();
  LinePlot plot;
  plot.title = "histories: " + tab.material->name() + ", " + tab.path.name;
  plot.x_label = shear ? "γ [1]" : straight ? "ε [1]" : "t [s]";
  plot.y_label = "τ_{" + index_text(shown) + "} [Pa]";
  // from rest, or from the family's lower end, to the end that is farther away
  const bool below = -range.lower > range.upper;
  const double from = range.lower <= 0 && range.upper >= 0 ? 0 : range.lower, to = below ? range.lower : range.upper;
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const double xi = from + share * (to - from);
    Series series;
    series.name = "ξ = " + rounded_text(xi, 3);
    for (int k = 0; k <= history_points; ++k) {
      stop_if_interrupted();
      const double t = tab.end * k / history_points;
      Tensor tau, slope;
      tab.response->at(xi, t, tau, slope);
      series.x.push_back(straight ? (shear ? 2 : 1) * tab.path.eps(xi, t) : t);
      series.y.push_back(component(tau, shown));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace assay::drivers
