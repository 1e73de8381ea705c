// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/convergence.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <charconv>
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "harness/numeric/number_text.hpp"

namespace assay {

namespace {

bool has_logarithm(double value) { return value > 0 && std::isfinite(value); }

std::string order_text(double order, int digits_after_point = 2) {
  if (std::abs(order) < 0.005) return "0.00";  // without a sign
  std::array<char, 400> text;
  const auto done =
      std::to_chars(text.data(), text.data() + text.size(), order, std::chars_format::fixed, digits_after_point);
  return {text.data(), done.ptr};
}

RangeJudgement unknown_range(const std::string& why) { return {AsymptoticRange::unknown, "unknown: " + why}; }

/// Half the width of the 95 % confidence interval of a slope. residual, variance: sums of squares; n > 2 points.
double half_interval(double residual, double variance, std::size_t n) {
  const double freedom = static_cast<double>(n - 2);
  const boost::math::students_t distribution(freedom);
  return boost::math::quantile(distribution, 0.975) * std::sqrt(residual / freedom / variance);
}

/// But for rounding: of their difference there is no order.
bool are_equal(double h, double other) { return std::abs(h - other) <= 1e-6 * std::abs(h); }

}  // namespace

std::optional<FittedOrder> fitted_order(const std::vector<double>& h, const std::vector<double>& error) {
  if (h.size() != error.size() || h.size() < 2 || !std::all_of(h.begin(), h.end(), has_logarithm) ||
      !std::all_of(error.begin(), error.end(), has_logarithm) ||
      std::all_of(h.begin(), h.end(), [&](double each) { return are_equal(h.front(), each); }))
    return std::nullopt;
  const double n = static_cast<double>(h.size());
  double x_mean = 0, y_mean = 0, covariance = 0, variance = 0, residual = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    x_mean += std::log(h[i]) / n;
    y_mean += std::log(error[i]) / n;
  }
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double x = std::log(h[i]) - x_mean;
    covariance += x * (std::log(error[i]) - y_mean);
    variance += x * x;
  }
  if (!(variance > 0)) return std::nullopt;
  FittedOrder fit;
  fit.order = covariance / variance;
  if (h.size() == 2) return fit;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double off = std::log(error[i]) - y_mean - fit.order * (std::log(h[i]) - x_mean);
    residual += off * off;
  }
  const double half = half_interval(residual, variance, h.size());
  fit.lower = fit.order - half;
  fit.upper = fit.order + half;
  return fit;
}

std::vector<std::optional<double>> pairwise_orders(const std::vector<double>& h, const std::vector<double>& error) {
  std::vector<std::optional<double>> orders(std::min(h.size(), error.size()));
  for (std::size_t i = 1; i < orders.size(); ++i) {
    if (!has_logarithm(h[i - 1]) || !has_logarithm(h[i]) || are_equal(h[i - 1], h[i])) continue;
    if (!has_logarithm(error[i - 1]) || !has_logarithm(error[i])) continue;
    orders[i] = observed_order(h[i - 1], error[i - 1], h[i], error[i]);
  }
  return orders;
}

RangeJudgement asymptotic_range(const std::vector<double>& h, const std::vector<double>& error) {
  const auto orders = pairwise_orders(h, error);
  const std::size_t n = orders.size();
  if (n < 3) return unknown_range(std::to_string(n) + (n == 1 ? " resolution" : " resolutions") + ", three are needed");
  if (are_equal(h[n - 3], h[n - 2]) || are_equal(h[n - 2], h[n - 1]))
    return unknown_range("two of the three finest are of one resolution, and no order lies between them");
  if (!orders[n - 2] || !orders[n - 1]) return unknown_range("an error of the three finest has no order");
  const double span = h[n - 3] / h[n - 1];
  if (!(h[n - 3] > h[n - 2] && h[n - 2] > h[n - 1]))
    return unknown_range("the resolutions do not go from coarse to fine");
  if (span < least_span * (1 - 1e-12)) {
    return unknown_range("the three finest span a factor of " + rounded_text(span, 3) + " in h, " +
                         rounded_text(least_span, 3) + " is needed");
  }
  const double coarse = *orders[n - 2], fine = *orders[n - 1], apart = std::abs(fine - coarse);
  const std::string found = "orders " + order_text(coarse) + " and " + order_text(fine) + " on the three finest";
  if (std::min(coarse, fine) < least_order) {
    return {AsymptoticRange::not_reached, "not reached: " + found + ", the error " +
                                              (std::min(coarse, fine) <= 0 ? "does not fall" : "hardly falls")};
  }
  const bool agree = apart <= order_tolerance;
  return {agree ? AsymptoticRange::reached : AsymptoticRange::not_reached,
          (agree ? "reached: " : "not reached: ") + found + " differ by " +
              order_text(apart, std::abs(apart - order_tolerance) < 0.005 ? 4 : 2) +
              (agree ? ", at most " : ", more than ") + rounded_text(order_tolerance, 3)};
}

}  // namespace assay
