// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/extrapolation.hpp"

#include <algorithm>
#include <limits>

namespace assay {

namespace {

constexpr int most = Extrapolation::most_columns;

enum class Series { every_power, from_second, even_powers };
constexpr Series all_series[] = {Series::every_power, Series::from_second, Series::even_powers};

/// Weights of the results first .. last (last + 1 sub-steps) in the extrapolated one; zero elsewhere.
std::array<double, most> weights(Series series, int first, int last) {
  std::array<double, most> w{};
  const auto x = [&](int i) { return std::pow(i + 1.0, series == Series::even_powers ? -2 : -1); };
  double sum = 0;
  for (int i = first; i <= last; ++i) {
    double weight = 1;
    for (int k = first; k <= last; ++k) {
      if (k != i) weight *= x(k) / (x(k) - x(i));
    }
    const auto at = static_cast<std::size_t>(i);
    w[at] = series == Series::from_second ? weight / x(i) : weight;
    sum += w[at];
  }
  for (double& weight : w) weight /= sum;  // 1 already but for from_second
  return w;
}

/// What weights make of the error (1/n)^power of n sub-steps.
double left_of(const std::array<double, most>& w, int power) {
  double sum = 0;
  for (int i = 0; i < most; ++i) sum += w[static_cast<std::size_t>(i)] * std::pow(i + 1.0, -power);
  return sum;
}

/// With the results 0 .. column.
struct Column {
  std::array<double, most> value;   ///< weights of the extrapolated result
  std::array<double, most> change;  ///< of its difference from the one without the coarsest result
  double margin = 1;                ///< error over the size of `change`
  double enlargement = 0;           ///< of rounding: sum of |weights|
};

Column column_of(Series series, int last) {
  Column c{weights(series, 0, last), weights(series, 1, last)};
  if (series == Series::even_powers) {
    const double left = left_of(c.value, 3), before = left_of(c.change, 3);
    c.margin = std::max(1.0, std::abs(left / (left - before)));
  }
  for (std::size_t i = 0; i < c.value.size(); ++i) {
    c.change[i] = c.value[i] - c.change[i];
    c.enlargement += std::abs(c.value[i]);
  }
  return c;
}

const Column& column(Series series, int last) {
  static const auto table = [] {
    std::array<std::array<Column, most>, std::size(all_series)> all;
    for (const Series s : all_series) {
      for (int j = 1; j < most; ++j) all[static_cast<std::size_t>(s)][static_cast<std::size_t>(j)] = column_of(s, j);
    }
    return all;
  }();
  return table[static_cast<std::size_t>(series)][static_cast<std::size_t>(last)];
}

double largest(std::span<const double> values, std::span<const double> scales) {
  double found = 0;
  for (std::size_t i = 0; i < values.size(); ++i) found = std::max(found, std::abs(values[i]) / scales[i]);
  return found;
}

}  // namespace

/// (1 - 1/4) / (1/4 - 1/9) = 5.4 for errors in h^2, (1 - 1/2) / (1/2 - 1/3) = 3 for errors in h.
bool Extrapolation::second_order() const {
  constexpr double between = 4.2, rounding = 1e-14;
  return rows_ >= 3 && (first_change_ > between * second_change_ || first_change_ < rounding);
}

void Extrapolation::add(std::span<const double> result, std::span<const double> scales) {
  const int last = rows_++;
  const auto& newest = results_[static_cast<std::size_t>(last)];
  results_[static_cast<std::size_t>(last)].assign(result.begin(), result.end());
  error_ = std::numeric_limits<double>::infinity();
  rounding_ = std::numeric_limits<double>::epsilon();
  best_ = newest;
  if (last == 0) return;
  change_.resize(result.size());
  if (last <= 2) {
    const auto& before = results_[static_cast<std::size_t>(last) - 1];
    for (std::size_t i = 0; i < result.size(); ++i) change_[i] = newest[i] - before[i];
    (last == 1 ? first_change_ : second_change_) = largest(change_, scales);
  }
  for (const Series series : all_series) {
    if (series != Series::every_power && !second_order()) break;
    const Column& c = column(series, last);
    value_ = newest;
    std::fill(change_.begin(), change_.end(), 0.0);
    for (std::size_t row = 0; row < static_cast<std::size_t>(last); ++row) {
      for (std::size_t i = 0; i < result.size(); ++i) {
        const double difference = results_[row][i] - newest[i];  // small: less rounding than the results themselves
        value_[i] += c.value[row] * difference;
        change_[i] += c.change[row] * difference;
      }
    }
    const double error = c.margin * largest(change_, scales);
    if (error < error_) {
      error_ = error;
      rounding_ = std::numeric_limits<double>::epsilon() * c.enlargement;
      best_.swap(value_);
    }
  }
}

}  // namespace assay
