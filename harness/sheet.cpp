// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet.hpp"

#include <algorithm>
#include <cmath>

#include "harness/chebyshev.hpp"
#include "harness/point_driver.hpp"

namespace assay {

namespace {

/// Coefficients below this fraction of the largest are rounding and are not evaluated.
constexpr double negligible = 5e-16;
/// The histories under a sheet are this much better than the sheet is asked to be.
constexpr double history_share = 1e-2;
constexpr double best_history_tolerance = 1e-13;
/// Step of the eighth-order central difference that checks d tau / d xi, as a share of the range of xi.
constexpr double check_step = 0.01;
constexpr int first_nodes = 9;
/// Places inside a range at which the error is looked for: irrational, so that no node family meets them.
constexpr double check_places[] = {0.0721, 0.2391, 0.4142, 0.6180, 0.8513, 0.9772};

std::vector<double> breaks_of(const Path& path, double end) {
  std::vector<double> breaks{0};
  for (const double t : path.reversals(end)) breaks.push_back(t);
  breaks.push_back(end);
  return breaks;
}

}  // namespace

Sheet::Sheet(const Material& material, const Path& path, const SheetOptions& options) : path_(path), end_(options.end) {
  if (material.path_independent()) {
    amplitude_ = path.amplitude;
    path_ = loading_path(path, options.end);
    end_ = 1;
  }
  const double history_tolerance = std::max(best_history_tolerance, history_share * options.tolerance);
  for (int n = first_nodes; n <= options.most_nodes; n = 2 * n - 1) {
    lay_out(n);
    tabulate(material, history_tolerance);
    estimate_error(material, history_tolerance);
    if (error_tau_ <= options.tolerance && error_dtau_ <= options.tolerance) return;
  }
}

/// n nodes in the parameter and in each piece of time; of a curve the end of the loading alone.
void Sheet::lay_out(int n) {
  nodes_ = chebyshev::nodes(path_.parameter, n);
  pieces_.clear();
  if (is_curve()) {
    pieces_.push_back({{end_, end_}, {end_}, {}});
    return;
  }
  const std::vector<double> breaks = breaks_of(path_, end_);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const Interval time{breaks[k], breaks[k + 1]};
    pieces_.push_back({time, chebyshev::nodes(time, n), {}});
  }
}

void Sheet::tabulate(const Material& material, double history_tolerance) {
  std::vector<double> times;
  for (const Piece& piece : pieces_) times.insert(times.end(), piece.nodes.begin(), piece.nodes.end());
  const Histories h = integrate_histories(material, path_, nodes_, times, {.tolerance = history_tolerance});
  material_calls_ += h.material_calls;
  const std::size_t n = nodes_.size();
  std::size_t row = 0;
  for (Piece& piece : pieces_) {
    piece.coefficients.resize(piece.nodes.size() * n * 9);
    for (std::size_t j = 0; j < piece.nodes.size(); ++j, ++row) {
      for (std::size_t c = 0; c < 9; ++c) {
        const auto terms = chebyshev::coefficients(std::span(h.tau[row]).subspan(c * n, n));
        for (std::size_t k = 0; k < n; ++k) piece.coefficients[(j * n + k) * 9 + c] = terms[k];
      }
    }
  }
}

/// Against histories at places off the nodes: tau directly, d tau / d xi by eighth-order central differences.
void Sheet::estimate_error(const Material& material, double history_tolerance) {
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  const Interval& range = path_.parameter;
  const double step = check_step * range.width();
  std::vector<double> xi, times;
  for (const double place : check_places) {
    const double centre = range.lower + (0.05 + 0.9 * place) * range.width();
    for (int k = -4; k <= 4; ++k) xi.push_back(centre + k * step);
  }
  for (const Piece& piece : pieces_) {
    for (const double place : check_places) {
      if (is_curve() && !times.empty()) break;
      times.push_back(piece.time.lower + place * piece.time.width());
    }
  }
  const Histories h = integrate_histories(material, path_, xi, times, {.tolerance = history_tolerance});
  material_calls_ += h.material_calls;
  double tau_scale = 0, dtau_scale = 0, tau_error = 0, dtau_error = 0;
  for (std::size_t row = 0; row < times.size(); ++row) {
    const Slice slice = cut(times[row]);
    for (std::size_t p = 4; p < xi.size(); p += 9) {
      Tensor tau, dtau;
      slice.at(xi[p], tau, dtau);
      for (std::size_t c = 0; c < 9; ++c) {
        const double* values = &h.tau[row][c * xi.size() + p];
        double slope = 0;
        for (int k = 1; k <= 4; ++k) slope += weights[k - 1] * (values[k] - values[-k]);
        slope = step > 0 ? slope / step : 0;
        tau_scale = std::max(tau_scale, std::abs(values[0]));
        dtau_scale = std::max(dtau_scale, std::abs(slope));
        tau_error = std::max(tau_error, std::abs(component(tau, static_cast<int>(c)) - values[0]));
        dtau_error = std::max(dtau_error, std::abs(component(dtau, static_cast<int>(c)) - slope));
      }
    }
  }
  error_tau_ = (tau_scale > 0 ? tau_error / tau_scale : 0) + h.error;
  error_dtau_ = dtau_scale > 0 ? dtau_error / dtau_scale : 0;
}

Sheet::Slice Sheet::slice(double t) const {
  if (!is_curve()) return cut(t);
  Slice result = cut(end_);
  result.factor_ = amplitude_(t);
  return result;
}

Sheet::Slice Sheet::cut(double t) const {
  const Piece* piece = &pieces_.front();
  for (const Piece& candidate : pieces_) {
    if (t >= candidate.time.lower) piece = &candidate;
  }
  const std::size_t n = nodes_.size();
  std::vector<double> weights(piece->nodes.size(), 1.0);
  if (weights.size() > 1) chebyshev::interpolation_weights(piece->time, t, weights);
  Slice result;
  result.parameter_ = path_.parameter;
  result.coefficients_.assign(9 * n, 0.0);
  double scale = 0;
  for (std::size_t j = 0; j < piece->nodes.size(); ++j) {
    const double* row = &piece->coefficients[j * n * 9];
    for (std::size_t i = 0; i < 9 * n; ++i) result.coefficients_[i] += weights[j] * row[i];
  }
  for (const double c : result.coefficients_) scale = std::max(scale, std::abs(c));
  for (std::size_t i = 0; i < 9 * n; ++i) {
    if (std::abs(result.coefficients_[i]) > negligible * scale) result.terms_ = i / 9 + 1;
  }
  return result;
}

void Sheet::Slice::at(double xi, Tensor& tau, Tensor& dtau_dxi) const {
  const double x = chebyshev::reference_coordinate(parameter_, factor_ * xi);
  const double scale = parameter_.width() > 0 ? 2 * factor_ / parameter_.width() : 0;
  tau.setZero();
  dtau_dxi.setZero();
  double T = 1, T_before = 0, D = 0, D_before = 0;  // T_k(x), T_{k-1}(x) and their derivatives
  for (std::size_t k = 0; k < terms_; ++k) {
    for (std::size_t c = 0; c < 9; ++c) {
      component(tau, static_cast<int>(c)) += coefficients_[k * 9 + c] * T;
      component(dtau_dxi, static_cast<int>(c)) += coefficients_[k * 9 + c] * D * scale;
    }
    const double T_next = k == 0 ? x : 2 * x * T - T_before;
    const double D_next = k == 0 ? 1 : 2 * T + 2 * x * D - D_before;
    T_before = T, D_before = D;
    T = T_next, D = D_next;
  }
}

std::int64_t Sheet::points() const { return static_cast<std::int64_t>(nodes_in_xi()) * nodes_in_t(); }

int Sheet::nodes_in_t() const {
  std::size_t sum = 0;
  for (const Piece& piece : pieces_) sum += piece.nodes.size();
  return static_cast<int>(sum);
}

}  // namespace assay
