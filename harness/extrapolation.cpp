// SPDX-License-Identifier: BSD-3-Clause
#include "harness/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assay {

namespace {

/// How much the extrapolation to column j enlarges the rounding of the results: sum of |weights|.
double enlargement(int j, int power) {
  double sum = 0;
  for (int i = 0; i <= j; ++i) {
    double weight = 1;
    for (int k = 0; k <= j; ++k) {
      if (k != i) weight /= 1 - std::pow(static_cast<double>(k + 1) / (i + 1), power);
    }
    sum += std::abs(weight);
  }
  return sum;
}

/// Everything that depends on column and power alone.
struct Factors {
  double difference[Extrapolation::most_columns][Extrapolation::most_columns] = {};  ///< [j][k]
  double enlargement[Extrapolation::most_columns] = {};
};

const Factors& factors_of(int power) {
  static const std::array<Factors, 2> table = [] {
    std::array<Factors, 2> all;
    for (int q = 1; q <= 2; ++q) {
      Factors& f = all[static_cast<std::size_t>(q - 1)];
      for (int j = 0; j < Extrapolation::most_columns; ++j) {
        f.enlargement[j] = enlargement(j, q);
        for (int k = 1; k <= j; ++k) f.difference[j][k] = 1 / (std::pow((j + 1.0) / (j + 1 - k), q) - 1);
      }
    }
    return all;
  }();
  return table[static_cast<std::size_t>(power - 1)];
}

}  // namespace

/// (1 - 1/4) / (1/4 - 1/9) = 5.4 for errors in h^2, (1 - 1/2) / (1/2 - 1/3) = 3 for errors in h.
bool Extrapolation::even_powers() const {
  constexpr double between = 4.2, rounding = 1e-14;
  return rows_ >= 3 && (first_change_ > between * second_change_ || first_change_ < rounding);
}

void Extrapolation::add(std::span<const double> result, std::span<const double> scales) {
  const int j = rows_++;
  if (j == 1 || j == 2) {
    double& change = j == 1 ? first_change_ : second_change_;
    change = 0;
    const auto& before = last_[0][0];  // the result of one sub-step fewer
    for (std::size_t i = 0; i < result.size(); ++i) {
      change = std::max(change, std::abs(result[i] - before[i]) / scales[i]);
    }
  }
  error_ = std::numeric_limits<double>::infinity();
  for (int power = 1; power <= 2; ++power) {
    const Factors& factors = factors_of(power);
    Row& last = last_[static_cast<std::size_t>(power - 1)];
    next_[0].assign(result.begin(), result.end());
    double error = std::numeric_limits<double>::infinity();
    for (int k = 1; k <= j; ++k) {
      const auto& before = next_[static_cast<std::size_t>(k - 1)];
      const auto& above = last[static_cast<std::size_t>(k - 1)];
      auto& value = next_[static_cast<std::size_t>(k)];
      value.resize(before.size());
      const double factor = factors.difference[j][k];
      error = 0;
      for (std::size_t i = 0; i < value.size(); ++i) {
        value[i] = before[i] + factor * (before[i] - above[i]);
        error = std::max(error, std::abs(value[i] - before[i]) / scales[i]);
      }
    }
    for (int k = 0; k <= j; ++k) last[static_cast<std::size_t>(k)].swap(next_[static_cast<std::size_t>(k)]);
    if (j == 0 || (error < error_ && (power == 1 || even_powers()))) {
      error_ = error;
      rounding_ = std::numeric_limits<double>::epsilon() * factors.enlargement[j];
      best_ = last[static_cast<std::size_t>(j)];
    }
  }
}

}  // namespace assay
