// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/expression_text.hpp"

#include <array>
#include <cstdio>

namespace assay::drivers {

std::vector<double> SingleNumbers::parts(double value) const {
  const double first = static_cast<float>(value), second = static_cast<float>(value - first);
  if (std::abs(second) < least_) return {first};
  return {first, second};
}

std::string SingleNumbers::text(double value) const {
  std::array<char, 64> digits;
  std::snprintf(digits.data(), digits.size(), "%.15f", value);
  std::string text = digits.data();
  text.erase(text.find_last_not_of('0') + 1);
  return text.ends_with('.') ? text + "0" : text;
}

std::string ExpressionText::plus(const std::string& sum, double c) const {
  std::string text = sum;
  for (const double part : numbers_.parts(c)) {
    if (part == 0 && !text.empty()) continue;
    if (part < 0) text += text.empty() ? "0-" : "-";
    if (part >= 0 && !text.empty()) text += "+";
    text += numbers_.text(std::abs(part));
  }
  return text;
}

std::string ExpressionText::plus(const std::string& sum, double c, const std::string& x) const {
  std::string text = sum;
  for (const double part : numbers_.parts(c)) {
    if (part == 0) continue;
    if (part < 0) text += text.empty() ? "0-" : "-";
    if (part >= 0 && !text.empty()) text += "+";
    text += x + "*" + numbers_.text(std::abs(part));
  }
  return text;
}

std::string ExpressionText::horner(const std::vector<double>& c, const std::string& x) const {
  if (c.size() == 1) return number(c[0]);
  std::string text = plus(plus("", c.back(), x), c[c.size() - 2]);
  for (std::size_t k = c.size() - 2; k-- > 0;) text = plus("(" + text + ")*" + x, c[k]);
  return text;
}

std::string ExpressionText::mapped(const Interval& interval, const std::string& x) const {
  const double scale = 2 / interval.width();
  return "(" + plus(plus("", scale, x), -scale * 0.5 * (interval.lower + interval.upper)) + ")";
}

}  // namespace assay::drivers
