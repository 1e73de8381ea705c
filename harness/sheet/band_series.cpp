// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/band_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/history/history.hpp"
#include "harness/numeric/chebyshev.hpp"
#include "harness/numeric/vector_clones.h"

namespace assay {

namespace {

/// Breaks whose times differ by less [share of the end] do not move: reversals.
constexpr double still = 1e-13;
/// A component of tau below this share of the largest is zero.
constexpr double inactive = 1e-15;
/// Of the range of xi: this near to an edge a history may be of the band beyond it.
constexpr double edge_noise = 1e-7;

/// T_k(2 s - 1) and their derivatives with respect to s.
struct Polynomials {
  Polynomials(double s, std::size_t n) : T(n), T_prime(n) {
    chebyshev::basis(2 * s - 1, T, T_prime);
    for (double& slope : T_prime) slope *= 2;
  }
  std::vector<double> T, T_prime;
};

/// Adds weight * numbers to n sums.
ASSAY_VECTOR_CLONES void add(double weight, const double* numbers, std::size_t n, double* __restrict sums) {
  for (std::size_t i = 0; i < n; ++i) sums[i] += weight * numbers[i];
}

/// Breaks with every stretch divided into parts, the shortest at its ends: there the motion begins or stops, or a kink
/// is not far.
std::vector<double> divided(const std::vector<double>& breaks, int parts) {
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    for (int k = 0; k < parts; ++k) {
      const double share = std::pow(std::sin(0.5 * std::numbers::pi * k / parts), 2);
      all.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * share);
    }
  }
  all.push_back(breaks.back());
  return all;
}

/// Of every stretch the nodes u in (0, 1), then its end: never descending, for breaks may lie on each other.
std::vector<double> node_times(const std::vector<double>& breaks, const std::vector<double>& u) {
  std::vector<double> times;
  double last = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double begin = breaks[i], width = breaks[i + 1] - begin;
    for (const double share : u) times.push_back(last = std::max(begin + share * width, last));
    times.push_back(last = std::max(breaks[i + 1], last));
  }
  return times;
}

}  // namespace

BandSeries::BandSeries(const Course& course, const Band& band, BandSize size, const HistoryOptions& options,
                       const Workers& workers)
    : band_(band), size_(size) {
  sample(course, options, workers);
  transform();
}

void BandSeries::sample(const Course& course, const HistoryOptions& options, const Workers& workers) {
  const std::size_t stretches = band_.stretches();
  const std::vector<double> s = chebyshev::gauss_nodes(size_.nodes_in_xi), u = chebyshev::gauss_nodes(size_.nodes_in_t);
  breaks_.resize((stretches + 1) * n_x());
  values_.resize(stretches * n_t() * n_x() * 9);
  std::vector<std::int64_t> calls(n_x());
  std::vector<double> errors(n_x());
  for_each_index(size_.nodes_in_xi, workers, [&](int index) {
    const auto k = static_cast<std::size_t>(index);
    const double xi = band_.map.xi_of(s[k]);
    Ray ray = band_.ray;
    if (options.watch && course.tells()) ray = trace(course, xi, options, calls[k]);
    if (ray.branches != band_.ray.branches) {
      // Next to an edge rounding decides between its two sides: the breaks are those a little further in.
      const double from_lower = xi - band_.map.xi.lower, from_upper = band_.map.xi.upper - xi;
      const double noise = edge_noise * course.path->parameter.width();
      if (std::min(from_lower, from_upper) > noise) throw StrayHistory{xi};
      ray = trace(course, from_lower < from_upper ? xi + noise : xi - noise, options, calls[k]);
      if (ray.branches != band_.ray.branches) throw StrayHistory{xi};
    }
    ray.breaks = divided(ray.breaks, band_.parts);
    for (std::size_t i = 0; i <= stretches; ++i) breaks_[i * n_x() + k] = ray.breaks[i];
    const std::vector<double> times = node_times(ray.breaks, u);
    const HistoryTrail trail = follow(course, xi, {.tolerance = options.tolerance, .watch = false}, times);
    for (std::size_t row = 0; row < times.size(); ++row) {
      if (row % (n_t() + 1) == n_t()) continue;  // a break
      const std::size_t node = row - row / (n_t() + 1);
      const Tensor tau = first_piola_kirchhoff(trail.cauchy(row), course.path->deformation_gradient(xi, times[row]));
      for (int c = 0; c < 9; ++c) values_[(node * n_x() + k) * 9 + static_cast<std::size_t>(c)] = component(tau, c);
    }
    calls[k] += trail.calls;
    errors[k] = trail.error;
  });
  for (const std::int64_t c : calls) calls_ += c;
  noise_ = *std::max_element(errors.begin(), errors.end());
}

/// Values to coefficients; leaves the components that are not zero.
void BandSeries::transform() {
  const std::size_t stretches = band_.stretches();
  const chebyshev::GaussTransform along_xi(size_.nodes_in_xi), along_t(size_.nodes_in_t);
  double largest[9] = {};
  for (std::size_t i = 0; i < values_.size(); ++i) largest[i % 9] = std::max(largest[i % 9], std::abs(values_[i]));
  largest_ = *std::max_element(largest, largest + 9);
  for (int c = 0; c < 9; ++c) {
    if (largest[c] > inactive * largest_) active_.push_back(c);
  }
  for (std::size_t i = 0; i <= stretches; ++i) {
    double* row = &breaks_[i * n_x()];
    const auto [low, high] = std::minmax_element(row, row + n_x());
    moves_.push_back(*high - *low > still * band_.ray.breaks.back());
    if (moves_.back()) {
      along_xi(row);
    } else {
      row[0] = 0.5 * (*low + *high);
      std::fill(row + 1, row + n_x(), 0.0);
    }
  }
  for (std::size_t line = 0; line < stretches * n_t(); ++line) {
    for (std::size_t c = 0; c < 9; ++c) along_xi(&values_[line * n_x() * 9 + c], 9);
  }
  for (std::size_t i = 0; i < stretches; ++i) {
    for (std::size_t column = 0; column < n_x() * 9; ++column) {
      along_t(&values_[i * n_t() * n_x() * 9 + column], n_x() * 9);
    }
  }
  const std::size_t rows = values_.size() / 9;
  coefficients_.resize(rows * active_.size());
  decay_xi_.assign(n_x(), 0.0);
  decay_t_.assign(n_t(), 0.0);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t a = 0; a < active_.size(); ++a) {
      const double value = values_[row * 9 + static_cast<std::size_t>(active_[a])];
      coefficients_[row * active_.size() + a] = value;
      double &of_xi = decay_xi_[row % n_x()], &of_t = decay_t_[row / n_x() % n_t()];
      of_xi = std::max(of_xi, std::abs(value));
      of_t = std::max(of_t, std::abs(value));
    }
  }
  values_ = {};
  tail_xi_ = *std::max_element(decay_xi_.end() - 2, decay_xi_.end());
  tail_t_ = *std::max_element(decay_t_.end() - 2, decay_t_.end());
  find_tail_of_breaks();
  find_break_ranges();
}

void BandSeries::find_break_ranges() {
  constexpr int samples = 33;
  for (std::size_t i = 0; i < moves_.size(); ++i) {
    Interval range{break_at(i, 0), break_at(i, 0)};
    for (int k = 1; moves_[i] && k < samples; ++k) {
      const double t = break_at(i, static_cast<double>(k) / (samples - 1));
      range = {std::min(range.lower, t), std::max(range.upper, t)};
    }
    break_range_.push_back(range);
  }
}

/// An error of a break's time moves tau by its rate in the stretches beside it.
void BandSeries::find_tail_of_breaks() {
  const std::size_t stretches = band_.stretches();
  for (std::size_t i = 1; i < stretches; ++i) {
    if (!moves_[i]) continue;
    double tail = 0;
    for (std::size_t k = n_x() - 2; k < n_x(); ++k) tail = std::max(tail, std::abs(breaks_[i * n_x() + k]));
    const double at = break_at(i, 0.5);
    const double width = std::min(at - break_at(i - 1, 0.5), break_at(i + 1, 0.5) - at);
    if (width > 0) tail_breaks_ = std::max(tail_breaks_, tail / width * largest_);
  }
}

double BandSeries::steepest() const {
  constexpr int samples = 5;
  double steepest = 0;
  Tensor tau, slope;
  for (int i = 0; i < samples; ++i) {
    const double s = (i + 0.5) / samples;
    for (std::size_t stretch = 0; stretch < band_.stretches(); ++stretch) {
      const double t = 0.5 * (break_at(stretch, s) + break_at(stretch + 1, s));
      at(band_.map.xi_of(s), t, tau, slope);
      steepest = std::max(steepest, slope.cwiseAbs().maxCoeff());
    }
  }
  return steepest;
}

bool BandSeries::any_moves() const { return std::find(moves_.begin(), moves_.end(), true) != moves_.end(); }

double BandSeries::break_at(std::size_t i, double s) const {
  if (!moves_[i]) return breaks_[i * n_x()];
  const Polynomials x(s, n_x());
  double t = 0;
  for (std::size_t k = 0; k < n_x(); ++k) t += breaks_[i * n_x() + k] * x.T[k];
  return t;
}

std::size_t BandSeries::stretch_at(double s, double t) const {
  std::size_t stretch = 0;
  while (stretch + 1 < band_.stretches() && t >= break_at(stretch + 1, s)) ++stretch;
  return stretch;
}

void BandSeries::sum_in_time(std::size_t stretch, const Interval& edges, double t, std::vector<double>& sums) const {
  const Polynomials time(edges.width() > 0 ? std::clamp((t - edges.lower) / edges.width(), 0.0, 1.0) : 0.5, n_t());
  sums.assign(n_x() * active_.size(), 0.0);
  for (std::size_t j = 0; j < n_t(); ++j) add(time.T[j], block(stretch, j), sums.size(), sums.data());
}

std::vector<double> BandSeries::cut(const Interval& s, double t) const {
  const std::size_t stretch = stretch_at(0.5 * (s.lower + s.upper), t), active = active_.size();
  const auto edges_at = [&](double place) { return Interval{break_at(stretch, place), break_at(stretch + 1, place)}; };
  std::vector<double> sums;
  if (!any_moves()) {
    sum_in_time(stretch, edges_at(0), t, sums);
    return sums;
  }
  const std::vector<double> nodes = chebyshev::gauss_nodes(size_.nodes_in_xi);
  std::vector<double> coefficients(n_x() * active);
  for (std::size_t node = 0; node < n_x(); ++node) {
    const double place = s.lower + nodes[node] * s.width();
    const Polynomials x(place, n_x());
    sum_in_time(stretch, edges_at(place), t, sums);
    for (std::size_t k = 0; k < n_x(); ++k) add(x.T[k], &sums[k * active], active, &coefficients[node * active]);
  }
  const chebyshev::GaussTransform to_coefficients(size_.nodes_in_xi);
  for (std::size_t c = 0; c < active; ++c) to_coefficients(&coefficients[c], active);
  return coefficients;
}

void BandSeries::at(double xi, double t, Tensor& tau, Tensor& dtau_dxi) const {
  const double s = band_.map.s_of(xi);
  const std::size_t stretch = stretch_at(s, t), active = active_.size();
  const Polynomials x(s, n_x());
  double edge[2] = {}, edge_slope[2] = {};  // of the stretch in time, and their derivatives in s
  for (std::size_t e = 0; e < 2; ++e) {
    const double* row = &breaks_[(stretch + e) * n_x()];
    for (std::size_t k = 0; k < n_x(); ++k) edge[e] += row[k] * x.T[k], edge_slope[e] += row[k] * x.T_prime[k];
  }
  const double width = edge[1] - edge[0];
  const double u = width > 0 ? std::clamp((t - edge[0]) / width, 0.0, 1.0) : 0.5;
  const double du_ds = width > 0 ? -(edge_slope[0] + u * (edge_slope[1] - edge_slope[0])) / width : 0;
  const Polynomials time(u, n_t());
  const double slope = band_.map.slope(s), ds_dxi = slope > 0 ? 1 / slope : 0;
  tau.setZero();
  dtau_dxi.setZero();
  for (std::size_t j = 0; j < n_t(); ++j) {
    const double* row = block(stretch, j);
    for (std::size_t k = 0; k < n_x(); ++k) {
      const double weight = time.T[j] * x.T[k];
      const double weight_slope = (time.T[j] * x.T_prime[k] + time.T_prime[j] * du_ds * x.T[k]) * ds_dxi;
      for (std::size_t c = 0; c < active; ++c) {
        component(tau, active_[c]) += weight * row[k * active + c];
        component(dtau_dxi, active_[c]) += weight_slope * row[k * active + c];
      }
    }
  }
}

}  // namespace assay
