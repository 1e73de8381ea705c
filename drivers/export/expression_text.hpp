// SPDX-License-Identifier: BSD-3-Clause
// Sums, products and polynomials as expressions that every language reads alike: no sign stands behind an operator or
// a parenthesis, and no number is negative.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "drivers/export/force_pieces.hpp"

namespace assay::drivers {

/// How a language takes numbers.
class ExpressionNumbers {
 public:
  virtual ~ExpressionNumbers() = default;
  /// Numbers whose sum is the value as far as it matters.
  virtual std::vector<double> parts(double value) const { return {value}; }
  /// Of a number that is not negative.
  virtual std::string text(double value) const { return coefficient_text(value); }
};

/// Karamelo reads every number in single precision and knows no exponents: a second number has what the first lacks.
class SingleNumbers final : public ExpressionNumbers {
 public:
  /// least: a second number below it does not matter; 15 decimals are kept.
  explicit SingleNumbers(double least = 1e-15) : least_(least) {}
  std::vector<double> parts(double value) const override;
  std::string text(double value) const override;

 private:
  double least_;
};

/// Expressions of a language.
class ExpressionText {
 public:
  explicit ExpressionText(const ExpressionNumbers& numbers) : numbers_(numbers) {}

  /// sum + c; of an empty sum c itself.
  std::string plus(const std::string& sum, double c) const;

  /// sum + c x.
  std::string plus(const std::string& sum, double c, const std::string& x) const;

  /// sum of c_k x^k by Horner's rule. x: a name or in parentheses.
  std::string horner(const std::vector<double>& c, const std::string& x) const;

  /// From -1 at the lower end of the interval to 1 at the upper one, in parentheses.
  std::string mapped(const Interval& interval, const std::string& x) const;

  std::string number(double value) const { return plus("", value); }

 private:
  const ExpressionNumbers& numbers_;
};

}  // namespace assay::drivers
