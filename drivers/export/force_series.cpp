// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_series.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "drivers/text/numbers.hpp"
#include "harness/numeric/chebyshev.hpp"

namespace assay::drivers {

namespace {

/// Significant digits of a coefficient. Powers of degree 16 lose six of them; what is left is 1e-8 of b and less.
constexpr int coefficient_digits = 15;

/// Shares of the tolerance that terms and powers that are left out may take.
constexpr double terms_share = 0.1, powers_share = 0.1, rounding_share = 1e-3;

/// sum of c_k T_k as coefficients of powers, as they are written. Those below `least` are rounding of even or odd
/// functions.
std::vector<double> in_powers(const std::vector<double>& c, double least) {
  std::vector<double> powers(c.size(), 0), before(c.size(), 0), now(c.size(), 0);  // T_(k-1), T_k
  now[0] = 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    for (std::size_t i = 0; i <= k; ++i) powers[i] += c[k] * now[i];
    std::vector<double> next(c.size(), 0);
    for (std::size_t i = 0; i + 1 < c.size(); ++i) next[i + 1] = (k == 0 ? 1 : 2) * now[i];
    if (k > 0)
      for (std::size_t i = 0; i < c.size(); ++i) next[i] -= before[i];
    before = now, now = next;
  }
  for (double& power : powers) power = std::abs(power) < least ? 0 : *parse_number(coefficient_text(power));
  while (powers.size() > 1 && powers.back() == 0) powers.pop_back();
  return powers;
}

/// The coefficients of a direction without those at the end that add up to less than `least`.
std::vector<double> without_tail(const Eigen::VectorXd& c, double least) {
  Eigen::Index n = c.size();
  double left_out = 0;
  while (n > 1 && left_out + std::abs(c(n - 1)) <= least) left_out += std::abs(c(--n));
  return {c.begin(), c.begin() + n};
}

double horner(const std::vector<double>& c, double x) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * x + c[k];
  return sum;
}

}  // namespace

std::string coefficient_text(double value) { return rounded_text(value, coefficient_digits); }

ForceMatrix chebyshev_coefficients(ForceMatrix values) {
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const std::vector<double> line(values.col(k).begin(), values.col(k).end());
    const std::vector<double> c = chebyshev::coefficients(line);
    for (Eigen::Index i = 0; i < values.rows(); ++i) values(i, k) = c[static_cast<std::size_t>(i)];
  }
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    const std::vector<double> line(values.row(i).begin(), values.row(i).end());
    const std::vector<double> c = chebyshev::coefficients(line);
    for (Eigen::Index k = 0; k < values.cols(); ++k) values(i, k) = c[static_cast<std::size_t>(k)];
  }
  return values;
}

ForceSeries separated(const ForceMatrix& coefficients, double least) {
  const Eigen::JacobiSVD<ForceMatrix> parts(coefficients, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& sizes = parts.singularValues();
  const auto weight = [&](Eigen::Index m) {  // of a term, at most
    return sizes(m) * parts.matrixU().col(m).lpNorm<1>() * parts.matrixV().col(m).lpNorm<1>();
  };
  Eigen::Index terms = sizes.size();
  double left_out = 0;
  while (terms > 0 && left_out + weight(terms - 1) <= terms_share * least) left_out += weight(--terms);
  ForceSeries series;
  for (Eigen::Index m = 0; m < terms; ++m) {
    const Eigen::VectorXd Q = parts.matrixV().col(m), P = sizes(m) * parts.matrixU().col(m);
    const double share = powers_share * least / static_cast<double>(terms);
    const double of_P = share / Q.lpNorm<1>(), of_Q = share / P.lpNorm<1>();
    series.push_back({in_powers(without_tail(P, of_P), rounding_share * of_P),
                      in_powers(without_tail(Q, of_Q), rounding_share * of_Q)});
  }
  return series;
}

std::array<double, 2> tails(const ForceMatrix& coefficients) {
  constexpr Eigen::Index last = 3;
  return {coefficients.bottomRows(last).cwiseAbs().sum(), coefficients.rightCols(last).cwiseAbs().sum()};
}

double value_of(const ForceSeries& series, double s, double u) {
  double sum = 0;
  for (const ForceTerm& term : series) sum += horner(term.P, s) * horner(term.Q, u);
  return sum;
}

}  // namespace assay::drivers
