// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/chebyshev.hpp"

#include <cmath>
#include <numbers>

namespace assay::chebyshev {

namespace {

/// x_j = -cos(j pi / (n-1)) as a sine, symmetric about 0 to the last bit.
double node(int j, int n) { return std::sin(std::numbers::pi * (2 * j - (n - 1)) / (2.0 * (n - 1))); }

}  // namespace

std::vector<double> nodes(const Interval& interval, int n) {
  std::vector<double> points(static_cast<std::size_t>(n));
  const double middle = 0.5 * (interval.lower + interval.upper);
  for (int j = 0; j < n; ++j) points[static_cast<std::size_t>(j)] = middle + 0.5 * interval.width() * node(j, n);
  points.front() = interval.lower;
  points.back() = interval.upper;
  return points;
}

std::vector<double> coefficients(std::span<const double> values) {
  const int n = static_cast<int>(values.size());
  std::vector<double> c(values.size(), 0.0);
  for (int k = 0; k < n; ++k) {
    double sum = 0;
    for (int j = 0; j < n; ++j) {
      // T_k(x_j) = cos(k theta_j), theta_j = pi (n-1-j)/(n-1); the argument reduced exactly in integers
      const int turns = (k * (n - 1 - j)) % (2 * (n - 1));
      const double end = j == 0 || j == n - 1 ? 0.5 : 1.0;
      sum += end * values[static_cast<std::size_t>(j)] * std::cos(std::numbers::pi * turns / (n - 1));
    }
    c[static_cast<std::size_t>(k)] = sum * (k == 0 || k == n - 1 ? 1.0 : 2.0) / (n - 1);
  }
  return c;
}

void basis(double x, std::span<double> T, std::span<double> T_prime) {
  const std::size_t n = T.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (k < 2) {
      T[k] = k == 0 ? 1 : x;
      T_prime[k] = k == 0 ? 0 : 1;
    } else {
      T[k] = 2 * x * T[k - 1] - T[k - 2];
      T_prime[k] = 2 * T[k - 1] + 2 * x * T_prime[k - 1] - T_prime[k - 2];
    }
  }
}

std::vector<double> gauss_nodes(int n) {
  std::vector<double> points(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) {
    const double half = std::sin(std::numbers::pi * (2 * j + 1) / (4.0 * n));
    points[static_cast<std::size_t>(j)] = half * half;  // (1 - cos theta) / 2 without cancellation near 0
  }
  return points;
}

GaussTransform::GaussTransform(int n) : n_(static_cast<std::size_t>(n)), matrix_(n_ * n_) {
  std::vector<double> cosines;  // of pi i / 2 n
  for (int i = 0; i < 4 * n; ++i) cosines.push_back(std::cos(std::numbers::pi * i / (2.0 * n)));
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {  // T_k(x_j), x_j = -cos(pi (2 j + 1) / 2 n), the argument reduced in integers
      const auto turns = static_cast<std::size_t>((k * (2 * (n - 1 - j) + 1)) % (4 * n));
      matrix_[static_cast<std::size_t>(k * n + j)] = cosines[turns] * (k == 0 ? 1.0 : 2.0) / n;
    }
  }
}

void GaussTransform::operator()(double* values, std::size_t stride) const {
  thread_local std::vector<double> line;
  line.resize(n_);
  for (std::size_t j = 0; j < n_; ++j) line[j] = values[j * stride];
  for (std::size_t k = 0; k < n_; ++k) {
    double sum = 0;
    for (std::size_t j = 0; j < n_; ++j) sum += matrix_[k * n_ + j] * line[j];
    values[k * stride] = sum;
  }
}

}  // namespace assay::chebyshev
