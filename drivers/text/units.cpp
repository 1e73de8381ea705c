// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/units.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

struct UnitSymbol {
  const char* word;
  Dimension dimension;
  Scale scale;
  bool of_author = false;  ///< may be chosen for all numbers of a file
};

constexpr double psi = 6894.757293168361;  // [Pa]
constexpr Dimension stress{.stress = 1}, length{.length = 1}, time_{.time = 1};
constexpr Dimension mass{.stress = 1, .length = 1, .time = 2};
constexpr Dimension force{.stress = 1, .length = 2}, energy{.stress = 1, .length = 3};
constexpr Dimension power{.stress = 1, .length = 3, .time = -1};

constexpr UnitSymbol symbols[] = {
    {"Pa", stress, {}, true},
    {"kPa", stress, {1e3, 1}, true},
    {"MPa", stress, {1e6, 1}, true},
    {"GPa", stress, {1e9, 1}, true},
    {"psi", stress, {psi, 1}, true},
    {"ksi", stress, {1e3 * psi, 1}, true},
    {"bar", stress, {1e5, 1}},
    {"s", time_, {}, true},
    {"ms", time_, {1, 1e3}, true},
    {"us", time_, {1, 1e6}, true},
    {"min", time_, {60, 1}, true},
    {"h", time_, {3600, 1}, true},
    {"m", length, {}, true},
    {"mm", length, {1, 1e3}, true},
    {"cm", length, {1, 1e2}, true},
    {"um", length, {1, 1e6}, true},
    {"in", length, {254, 1e4}, true},
    {"km", length, {1e3, 1}},
    {"kg", mass, {}},
    {"t", mass, {1e3, 1}},
    {"g", mass, {1, 1e3}},
    {"mg", mass, {1, 1e6}},
    {"N", force, {}},
    {"kN", force, {1e3, 1}},
    {"J", energy, {}},
    {"kJ", energy, {1e3, 1}},
    {"mJ", energy, {1, 1e3}},
    {"W", power, {}},
    {"K", {.temperature = 1}, {}},
    {"degC", {.temperature = 1}, {}},
    {"1", {}, {}},
    {"-", {}, {}},
    {"%", {}, {1, 1e2}},
    {"rad", {}, {}},
    {"deg", {.degrees = 1}, {}},
};

const UnitSymbol* symbol_of(std::string_view word) {
  const auto found =
      std::ranges::find(symbols, word, [](const UnitSymbol& each) { return std::string_view(each.word); });
  return found == std::end(symbols) ? nullptr : found;
}

Scale power_of(const Scale& scale, double exponent) {
  const Scale base = exponent < 0 ? Scale{scale.down, scale.up} : scale;
  return {std::pow(base.up, std::abs(exponent)), std::pow(base.down, std::abs(exponent))};
}

Scale product_of(const Scale& a, const Scale& b) { return {a.up * b.up, a.down * b.down}; }

/// "mm^2", "m3", "s^-1": the number of characters that it takes, 0 where it is none.
std::size_t read_factor(std::string_view text, bool divides, Unit& product) {
  std::size_t end = 0;
  while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
  if (end == 0 && !text.empty() && std::string_view("1-%").find(text[0]) != std::string_view::npos) end = 1;
  const UnitSymbol* symbol = symbol_of(text.substr(0, end));
  if (!symbol) return 0;
  std::size_t number = end;
  if (number < text.size() && text[number] == '^') ++number;
  std::size_t behind = number;
  if (symbol->word != std::string_view("1")) {
    if (behind < text.size() && text[behind] == '-') ++behind;
    while (behind < text.size() && (std::isdigit(static_cast<unsigned char>(text[behind])) || text[behind] == '.'))
      ++behind;
  }
  double exponent = 1;
  if (behind > number) {
    const auto read = parse_number(text.substr(number, behind - number));
    if (!read || !(std::abs(*read) <= 9)) return 0;
    exponent = *read;
  } else if (number > end) {
    return 0;
  }
  if (divides) exponent = -exponent;
  product.dimension = product.dimension * symbol->dimension.power(exponent);
  product.scale = product_of(product.scale, power_of(symbol->scale, exponent));
  return behind;
}

std::string powered(const std::string& word, double exponent) {
  return exponent == 1 ? word : word + "^" + number_text(exponent);
}

/// "a b/c^2".
std::string product_text(const std::vector<std::pair<std::string, double>>& factors) {
  std::string above, below;
  for (const auto& [word, exponent] : factors) {
    if (exponent > 0) above += (above.empty() ? "" : " ") + powered(word, exponent);
    if (exponent < 0) below += "/" + powered(word, -exponent);
  }
  return (above.empty() ? "1" : above) + below;
}

}  // namespace

Dimension operator*(const Dimension& a, const Dimension& b) {
  return {a.stress + b.stress, a.length + b.length, a.time + b.time, a.temperature + b.temperature,
          a.degrees + b.degrees};
}

Dimension Dimension::power(double exponent) const {
  return {stress * exponent, length * exponent, time * exponent, temperature * exponent, degrees * exponent};
}

std::optional<Unit> parse_unit(std::string_view text) {
  Unit product;
  bool divides = false, expects = true;
  while (!text.empty()) {
    const char first = text.front();
    if (first == ' ' || (!expects && (first == '*' || first == '/'))) {
      if (first != ' ') divides = first == '/', expects = true;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t taken = read_factor(text, divides, product);
    if (taken == 0) return std::nullopt;
    text.remove_prefix(taken);
    divides = expects = false;
    if (!text.empty() && std::string_view(" */").find(text.front()) == std::string_view::npos) return std::nullopt;
  }
  return expects ? std::nullopt : std::optional(product);
}

std::vector<std::string> unit_words(std::string_view of) {
  std::vector<std::string> words;
  for (const UnitSymbol& each : symbols) {
    if (each.of_author && each.dimension == symbol_of(of)->dimension) words.emplace_back(each.word);
  }
  return words;
}

Scale Units::scale(const Dimension& dimension) const {
  Scale scale;
  const auto add = [&](const std::string& word, double exponent) {
    if (exponent != 0) scale = product_of(scale, power_of(symbol_of(word)->scale, exponent));
  };
  add(stress, dimension.stress), add(length, dimension.length), add(time, dimension.time);
  return scale;
}

Scale Units::scale(std::string_view si_unit) const {
  const auto unit = parse_unit(si_unit);
  return unit && unit->scale.is_one() ? scale(unit->dimension) : Scale();
}

std::string Units::name(const Dimension& dimension) const {
  if (dimension == mass * Dimension{.length = -3}) {  // a density
    const Scale one = scale(mass);
    for (const UnitSymbol& each : symbols) {
      if (each.dimension == mass && each.scale.up * one.down == each.scale.down * one.up)
        return product_text({{each.word, 1}, {length, -3}});
    }
  }
  return product_text({{stress, dimension.stress},
                       {length, dimension.length},
                       {time, dimension.time},
                       {"K", dimension.temperature},
                       {"deg", dimension.degrees}});
}

std::string Units::name(std::string_view si_unit) const {
  const auto unit = parse_unit(si_unit);
  const bool stays = is_si() || !unit || !unit->scale.is_one() || unit->dimension.is_number();
  return stays ? std::string(si_unit) : name(unit->dimension);
}

std::string Units::text(double value, std::string_view si_unit) const {
  return number_text(scale(si_unit).from_si(value)) + " " + name(si_unit);
}

std::string Units::text(double value, std::string_view si_unit, int digits) const {
  return rounded_text(scale(si_unit).from_si(value), digits) + " " + name(si_unit);
}

std::string Units::words() const { return "length: " + length + ", stress: " + stress + ", time: " + time; }

Heading heading_of(const std::string& text) {
  const auto part = [&](std::size_t first, std::size_t behind) {
    return std::string(stripped(std::string_view(text).substr(first, behind - first)));
  };
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t at = text.rfind(open);
    if (at != text.npos && at > 0 && text.back() == close) return {part(0, at), part(at + 1, text.size() - 1)};
  }
  const std::size_t slash = text.rfind('/');
  if (slash != text.npos && slash > 0 && slash + 1 < text.size()) return {part(0, slash), part(slash + 1, text.size())};
  return {part(0, text.size()), ""};
}

}  // namespace assay::drivers
