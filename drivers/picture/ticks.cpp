// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/ticks.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "drivers/picture/stroke_font.hpp"

namespace assay::drivers {

namespace {

constexpr const char* minus = "\u2212";

std::string fixed_text(double value, int decimals) {
  std::array<char, 64> buffer;
  const auto done =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::fixed, decimals);
  const std::string text(buffer.data(), done.ptr);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? minus : "") + text;
}

std::string power_text(int exponent) {
  return "10^{" + (exponent < 0 ? minus + std::to_string(-exponent) : std::to_string(exponent)) + "}";
}

double power(int exponent) { return std::pow(10.0, exponent); }

int decade_below(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }

/// 1, 2 or 5 times a power of ten.
double nice_step(double range, int target) {
  const double rough = range / target, unit = power(decade_below(rough)), m = rough / unit;
  return unit * (m <= 1.4 ? 1 : m <= 3.2 ? 2 : m <= 7.1 ? 5 : 10);
}

void mark_linear(Axis& axis, Fit fit, int target) {
  const double step = nice_step(axis.high - axis.low, target);
  if (fit == Fit::rounded) {
    axis.low = std::floor(axis.low / step + 1e-9) * step;
    axis.high = std::ceil(axis.high / step - 1e-9) * step;
  }
  const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
  const int magnitude = decade_below(largest);
  const int shift = magnitude < -2 || magnitude > 4 ? magnitude : 0;
  if (shift != 0) axis.factor = "\u00d7" + power_text(shift);
  const int decimals = std::clamp(shift - decade_below(step), 0, 15);
  const double first = std::ceil(axis.low / step - 1e-9), last = std::floor(axis.high / step + 1e-9);
  for (double k = first; k <= last; ++k) {
    axis.major.push_back(k * step);
    axis.labels.push_back(fixed_text(k * step / power(shift), decimals));
  }
}

void mark_logarithmic(Axis& axis, Fit fit, int target) {
  int first = decade_below(axis.low), last = static_cast<int>(std::ceil(std::log10(axis.high) - 1e-9));
  if (fit == Fit::rounded && last - first > 1) {
    axis.low = power(first);
    axis.high = power(last);
  } else if (fit == Fit::rounded) {
    const auto grow = [](double value, bool up) {
      const double unit = power(decade_below(value)), m = value / unit;
      if (up) return unit * (m <= 1.0001 ? 1 : m <= 2.0001 ? 2 : m <= 5.0001 ? 5 : 10);
      return unit * (m >= 4.9999 ? 5 : m >= 1.9999 ? 2 : 1);
    };
    axis.low = grow(axis.low, false);
    axis.high = grow(axis.high, true);
  }
  const int stride = std::max(1, (last - first + target) / (target + 1));
  const bool dense = std::log10(axis.high / axis.low) < 1.6;  // few decades: 2 and 5 are written too
  const bool plain = dense && axis.low > 0.0099 && axis.high < 10001;
  for (int decade = first; decade <= last; ++decade) {
    for (int m = 1; m <= 9; ++m) {
      const double value = m * power(decade);
      if (value < axis.low * (1 - 1e-9) || value > axis.high * (1 + 1e-9)) continue;
      if ((m == 1 && (decade - first) % stride == 0) || (dense && (m == 2 || m == 5))) {
        axis.major.push_back(value);
        axis.labels.push_back(plain    ? fixed_text(value, std::max(0, -decade))
                              : m == 1 ? power_text(decade)
                                       : std::to_string(m) + "\u00b7" + power_text(decade));
      } else if (stride == 1 || m == 1) {
        axis.minor.push_back(value);
      }
    }
  }
}

}  // namespace

double Axis::fraction(double value) const {
  return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

std::string Axis::titled(const std::string& label) const {
  if (factor.empty()) return label;
  return label.empty() ? factor : label + "  (" + factor + ")";
}

double Axis::widest_label(double size) const {
  double widest = 0;
  for (const std::string& label : labels) widest = std::max(widest, label_width(label, size));
  return widest;
}

Axis make_axis(double low, double high, bool logarithmic, Fit fit, int target) {
  Axis axis;
  axis.logarithmic = logarithmic;
  if (logarithmic) {
    if (!(high > low * (1 + 1e-6))) low /= 2, high = low * 4;
    axis.low = std::max(low, 1e-290);
    axis.high = std::clamp(high, 4 * axis.low, 1e290);
    mark_logarithmic(axis, fit, target);
    return axis;
  }
  // Room that the marks can be told apart in.
  const double room = std::max({std::abs(low), std::abs(high), 1e-290}) * 1e-9;
  if (!(high - low > room)) {
    const double middle = low / 2 + high / 2, half = middle == 0 ? 1 : std::abs(middle) * 0.1;
    low = middle - half;
    high = middle + half;
  }
  axis.low = std::clamp(low, -1e290, 1e290);
  axis.high = std::clamp(high, -1e290, 1e290);
  mark_linear(axis, fit, target);
  return axis;
}

}  // namespace assay::drivers
