// SPDX-License-Identifier: BSD-3-Clause
// The one table of units: what a unit measures, and the coherent units in which an author writes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace assay::drivers {

/// Exponents of stress, length, time, temperature, and degrees of an angle, which stay what they are. A mass is a
/// stress times length times time squared.
struct Dimension {
  double stress = 0, length = 0, time = 0, temperature = 0, degrees = 0;

  bool is_number() const { return *this == Dimension(); }
  friend bool operator==(const Dimension&, const Dimension&) = default;
  friend Dimension operator*(const Dimension& a, const Dimension& b);
  Dimension power(double exponent) const;
};

/// What a number in some unit is in SI: value times up, divided by down. Both are whole where the unit allows, so that
/// 1250 mm is 1.25 m to the last bit.
struct Scale {
  double up = 1, down = 1;

  double to_si(double value) const { return value * up / down; }
  double from_si(double value) const { return value * down / up; }
  bool is_one() const { return up == down; }
  friend bool operator==(const Scale&, const Scale&) = default;
};

struct Unit {
  Dimension dimension;
  Scale scale;
};

/// Products and quotients of units with powers: "Pa", "kg/m^3", "N/mm2", "Pa s", "1/min", "%". Nothing where a word is
/// no unit. rad is a number, deg is none; a temperature is one difference of it, without the zero of degC.
std::optional<Unit> parse_unit(std::string_view text);

/// The units in which an author may write what has the dimension of "Pa", "s" or "m".
std::vector<std::string> unit_words(std::string_view of);

/// The units of an author: words of `unit_words`.
struct Units {
  std::string length = "m", stress = "Pa", time = "s";

  bool is_si() const { return *this == Units(); }
  Scale scale(const Dimension& dimension) const;
  /// Of an SI unit: "kg/m^3". One where the word is no unit, or no coherent SI unit: such numbers stay as they are.
  Scale scale(std::string_view si_unit) const;
  /// "MPa", "mm/s", "t/mm^3".
  std::string name(const Dimension& dimension) const;
  /// Of an SI unit; the same word where numbers in it stay as they are.
  std::string name(std::string_view si_unit) const;
  /// A number in an SI unit with its unit: "0.5 s" is "500 ms".
  std::string text(double value, std::string_view si_unit) const;
  std::string text(double value, std::string_view si_unit, int digits) const;
  /// "length: mm, stress: MPa, time: s".
  std::string words() const;
  friend bool operator==(const Units&, const Units&) = default;
};

/// The head of a column as people write it: "stress [MPa]", "stress (MPa)", "stress / MPa".
struct Heading {
  std::string name, unit;
};
Heading heading_of(const std::string& text);

}  // namespace assay::drivers
