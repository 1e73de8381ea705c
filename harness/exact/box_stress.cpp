// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/box_stress.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "harness/material/checked_update.hpp"

namespace assay {

namespace {

constexpr int fewest_modes = 8;
constexpr int trial_times = 24;                        ///< at which the number of modes is tried out
constexpr double trial_periods = 2;                    ///< over which
constexpr double share_a_step = 1e-3;                  ///< of a step, of what is asked of the whole
constexpr double least_tolerance = 1e-13;              ///< of a step
constexpr std::size_t piola_components[] = {0, 4, 8};  // 11, 22, 33 of nine

/// sin(x)/x.
double sinc(double x) { return std::abs(x) < 1e-8 ? 1 : std::sin(x) / x; }

}  // namespace

BoxStress::BoxStress(std::shared_ptr<const Material> material, const AxisAligned& motion, const BoxOptions& options)
    : material_(std::move(material)), motion_(motion), options_(options) {
  const double trial = std::min(options.end, trial_periods * motion.amplitude.period);
  for (int modes = fewest_modes;; modes *= 2) {
    lay_out(std::min(modes, options.most_modes), trial);
    for (int k = 1; k <= trial_times; ++k) set_time(trial * k / trial_times);
    if (error() <= options.tolerance || modes >= options.most_modes) break;
  }
  begin_again();
}

void BoxStress::begin_again() {
  if (is_history()) lay_out(series_.modes(0), options_.end);
  t_ = -1, last_modes_ = scale_ = 0;
}

void BoxStress::lay_out(int modes_wanted, double end) {
  const std::array<int, 2> modes{modes_wanted, motion_.one_dimensional ? 1 : modes_wanted};
  series_.modes_ = modes;
  t_ = -1, last_modes_ = scale_ = 0;
  const std::size_t n = static_cast<std::size_t>(modes[0]) * static_cast<std::size_t>(modes[1]);
  along_X_ = std::make_unique<chebyshev::GaussTransform>(modes[0]);
  along_Y_ = std::make_unique<chebyshev::GaussTransform>(modes[1]);
  histories_.clear(), courses_.clear(), sections_.clear(), xi_.clear();
  for (const double s : chebyshev::gauss_nodes(modes[0])) xi_.push_back(2 * s - 1);
  for (const double s : chebyshev::gauss_nodes(modes[1])) {
    sections_.push_back(std::make_unique<Path>(motion_.section(2 * s - 1)));
    sections_.back()->material_direction = options_.direction;
    sections_.back()->initial_cauchy = options_.initial_cauchy;
  }
  for (auto& values : series_.coefficients_) values.assign(n, 0);
  if (material_->is_function_of_F()) {
    state_ = material_->initial_state(n, {}, {});
    F0_.assign(9 * n, 0), F1_.assign(9 * n, 0), cauchy_.assign(9 * n, 0), after_.assign(state_.size(), 0);
    for (const std::size_t c : {0, 4, 8}) std::fill_n(F0_.begin() + static_cast<std::ptrdiff_t>(c * n), n, 1.0);
    F1_ = F0_;
    return;
  }
  const double tolerance = std::max(least_tolerance, share_a_step * options_.tolerance);
  const bool watch = material_->has(ASSAY_NON_SMOOTH);
  for (const auto& section : sections_) courses_.push_back(std::make_unique<Course>(*material_, *section, end));
  for (const auto& course : courses_) {
    histories_.emplace_back(*course, xi_, HistoryOptions{.tolerance = tolerance, .watch = watch});
  }
}

void BoxStress::set_time(double t) {
  if (t == t_) return;
  if (is_history()) {
    if (t < t_) throw std::logic_error("BoxStress: histories do not go back in time");
    for (std::size_t j = 0; j < histories_.size(); ++j) {
      histories_[j].advance(t);
      for (std::size_t i = 0; i < xi_.size(); ++i) {
        const Tensor tau = histories_[j].tau(i);
        for (std::size_t c = 0; c < BoxSeries::components; ++c) {
          series_.coefficients_[c][i * histories_.size() + j] = tau(static_cast<int>(c), static_cast<int>(c));
        }
      }
    }
  } else {
    update_nodes(t);
  }
  t_ = t;
  find_coefficients();
  measure();
}

/// P = J sigma F^-T with F diagonal.
void BoxStress::update_nodes(double t) {
  const std::size_t n_Y = sections_.size(), n = xi_.size() * n_Y;
  for (std::size_t i = 0; i < xi_.size(); ++i) {
    for (std::size_t j = 0; j < n_Y; ++j) {
      const Tensor F = sections_[j]->deformation_gradient(xi_[i], t);
      for (int c = 0; c < 3; ++c) F1_[piola_components[c] * n + i * n_Y + j] = F(c, c);
    }
  }
  checked_update(*material_, xi_.front(), 0, t > 0 ? t : 1, n, F0_.data(), F1_.data(), state_.data(), after_.data(),
                 cauchy_.data());
  calls_ += static_cast<std::int64_t>(n);
  for (std::size_t p = 0; p < n; ++p) {
    const double J = F1_[p] * F1_[4 * n + p] * F1_[8 * n + p];
    for (std::size_t c = 0; c < BoxSeries::components; ++c) {
      const std::size_t at = piola_components[c] * n + p;
      series_.coefficients_[c][p] = J * cauchy_[at] / F1_[at];
    }
  }
}

void BoxStress::find_coefficients() {
  const std::size_t n_X = xi_.size(), n_Y = sections_.size();
  for (auto& values : series_.coefficients_) {
    for (std::size_t i = 0; i < n_X; ++i) (*along_Y_)(values.data() + i * n_Y);
    for (std::size_t j = 0; j < n_Y; ++j) (*along_X_)(values.data() + j, n_Y);
  }
}

/// Of the last two modes in each direction.
void BoxStress::measure() {
  const std::size_t n_X = xi_.size(), n_Y = sections_.size();
  for (const auto& values : series_.coefficients_) {
    for (std::size_t k = 0; k < n_X; ++k) {
      for (std::size_t l = 0; l < n_Y; ++l) {
        const double value = std::abs(values[k * n_Y + l]);
        scale_ = std::max(scale_, value);
        if (k + 2 >= n_X || (n_Y > 1 && l + 2 >= n_Y)) last_modes_ = std::max(last_modes_, value);
      }
    }
  }
}

void BoxSeries::contract(std::size_t component, std::size_t d, std::span<const double> weights,
                         std::span<double> sums) const {
  const std::span<const double> c = coefficients_[component];
  const auto n_Y = static_cast<std::size_t>(modes(1)), stride = d == 0 ? n_Y : 1, across = d == 0 ? 1 : n_Y;
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    for (std::size_t l = 0; l < sums.size(); ++l) sums[l] += weights[k] * c[k * stride + l * across];
  }
}

BoxSeries::Local BoxSeries::at(double X, double Y) const {
  const std::array place_X{Interval{X, X}}, place_Y{Interval{Y, Y}};
  const CosineRows in_X(modes(0), place_X), in_Y(modes(1), place_Y);
  std::vector<double> value(in_X.mean(0).size()), slope(value.size());  // along Y, of each mode in X
  Local local;
  for (std::size_t c = 0; c < components; ++c) {
    contract(c, 1, in_Y.mean(0), value);
    contract(c, 1, in_Y.slope(0), slope);
    local.piola[c] = sum_of_modes(in_X.mean(0), value);
    local.along_X[c] = sum_of_modes(in_X.slope(0), value);
    local.along_Y[c] = sum_of_modes(in_X.mean(0), slope);
  }
  return local;
}

std::int64_t BoxStress::material_calls() const {
  std::int64_t calls = calls_;
  for (const Troop& troop : histories_) calls += troop.calls();
  return calls;
}

CosineRows::CosineRows(int modes, std::span<const Interval> stretches) : modes_(static_cast<std::size_t>(modes)) {
  using std::numbers::pi;
  std::map<std::pair<double, double>, std::uint32_t> known;
  for (const Interval& stretch : stretches) {
    const auto [it, is_new] =
        known.try_emplace({stretch.lower, stretch.upper}, static_cast<std::uint32_t>(mean_sine_.size()));
    row_.push_back(it->second);
    if (!is_new) continue;
    const double middle = 0.5 * (stretch.lower + stretch.upper), half = 0.5 * pi * stretch.width();
    for (int k = 0; k < modes; ++k) {  // the mean of exp(i k pi X) is that of its middle times sinc
      mean_.push_back(std::cos(k * pi * middle) * sinc(k * half));
      slope_.push_back(-k * pi * std::sin(k * pi * middle) * sinc(k * half));
    }
    mean_sine_.push_back(std::sin(pi * middle) * sinc(half));
  }
}

}  // namespace assay
