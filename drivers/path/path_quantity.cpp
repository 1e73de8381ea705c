// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_quantity.hpp"

#include <algorithm>
#include <cctype>

#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr const char* families[] = {"tau", "sigma", "F", "e", "L", "s", "P"};

/// "e11" as a component; nothing where it is none.
std::optional<PathTerm> component_of(const std::string& word) {
  for (const std::string family : families) {
    if (!word.starts_with(family) || word.size() != family.size() + 2) continue;
    const int i = word[family.size()] - '1', j = word[family.size() + 1] - '1';
    if (i < 0 || i > 2 || j < 0 || j > 2) continue;
    PathTerm term{family == "sigma" ? "s" : family, i, j};
    if (term.symmetric() && term.i > term.j) std::swap(term.i, term.j);
    return term;
  }
  return std::nullopt;
}

/// Behind "e+9" of a number; where none is, as in "2 e11" or "2e11", the place itself.
std::size_t behind_exponent(const std::string& text, std::size_t at) {
  std::size_t end = at;
  if (end == 0 || end >= text.size() || (text[end] != 'e' && text[end] != 'E')) return at;
  if (!std::isdigit(static_cast<unsigned char>(text[end - 1])) && text[end - 1] != '.') return at;
  ++end;
  if (end < text.size() && (text[end] == '+' || text[end] == '-')) ++end;
  const std::size_t digits = end;
  while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
  const bool goes_on = end < text.size() && (text[end] == ' ' || text[end] == '*');
  const std::size_t next = goes_on ? text.find_first_not_of(" *", end) : text.npos;
  const bool number = end > digits && next != text.npos && std::isalpha(static_cast<unsigned char>(text[next]));
  return number ? end : at;
}

std::vector<PathTerm> terms_of(const std::string& word) {
  std::vector<PathTerm> terms;
  if (const auto one = component_of(word)) terms.push_back(*one);
  if (word == "lnJ") terms.push_back({"lnJ"});
  if (word == "J" || word == "detF") terms.push_back({"J"});
  for (int i = 0; i < 3; ++i) {
    if (word == "volume") terms.push_back({"e", i, i});
    if (word == "pressure") terms.push_back({"s", i, i, -1.0 / 3});
  }
  return terms;
}

}  // namespace

bool PathQuantity::of_stress() const { return std::ranges::any_of(terms, &PathTerm::of_stress); }

bool PathQuantity::of_deformation() const {
  return std::ranges::any_of(terms, [](const PathTerm& term) { return !term.of_stress(); });
}

std::string PathQuantity::component() const {
  if (terms.size() != 1 || terms[0].factor != 1 || terms[0].of_J()) return {};
  return terms[0].indices();
}

std::optional<PathQuantity> parse_quantity(const std::string& text, std::string& fault) {
  PathQuantity quantity{text, {}};
  std::size_t at = 0;
  const auto skip = [&] {
    while (at < text.size() && text[at] == ' ') ++at;
  };
  for (bool first = true; skip(), at < text.size(); first = false) {
    double sign = 1;
    if (text[at] == '+' || text[at] == '-') {
      sign = text[at++] == '-' ? -1 : 1;
      skip();
    } else if (!first) {
      fault = "'" + text.substr(at) + "' follows without + or -";
      return std::nullopt;
    }
    const std::size_t number = at;
    while (at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.')) ++at;
    at = behind_exponent(text, at);
    double factor = 1;
    if (at > number) {
      const auto value = parse_number(text.substr(number, at - number));
      if (!value) {
        fault = "'" + text.substr(number, at - number) + "' is no number";
        return std::nullopt;
      }
      factor = *value;
      skip();
      if (at < text.size() && text[at] == '*') ++at, skip();
    }
    const std::size_t word = at;
    while (at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]))) ++at;
    const std::string name = text.substr(word, at - word);
    std::vector<PathTerm> terms = terms_of(name);
    if (terms.empty()) {
      fault = name.empty() ? "a component is missing" : "'" + name + "' is no component";
      return std::nullopt;
    }
    for (PathTerm& term : terms) {
      term.factor *= sign * factor;
      quantity.terms.push_back(term);
    }
  }
  if (quantity.terms.empty()) fault = "is empty";
  return quantity.terms.empty() ? std::nullopt : std::optional(quantity);
}

std::optional<PathMeasures> measures_of(const std::vector<PathQuantity>& quantities, std::string& fault) {
  PathMeasures found;
  std::string deformation, stress;
  for (const PathQuantity& quantity : quantities) {
    for (const PathTerm& term : quantity.terms) {
      if (term.of_J()) continue;
      std::string& seen = term.of_stress() ? stress : deformation;
      if (!seen.empty() && seen != term.family) {
        fault = "a path is controlled by " +
                std::string(term.of_stress() ? "one measure of stress" : "one measure of deformation") + ": " + seen +
                " stands beside " + term.family;
        return std::nullopt;
      }
      seen = term.family;
    }
    const bool rates = std::ranges::any_of(quantity.terms, [](const PathTerm& term) { return term.family == "L"; });
    if (rates && (quantity.of_stress() || std::ranges::any_of(quantity.terms, &PathTerm::of_J))) {
      fault = "a velocity gradient cannot stand in one sum with a stress, with J or with lnJ";
      return std::nullopt;
    }
  }
  if (!deformation.empty())
    found.deformation = deformation == "F"   ? Deformation::gradient
                        : deformation == "e" ? Deformation::logarithmic_strain
                                             : Deformation::velocity_gradient;
  if (!stress.empty())
    found.stress = stress == "s"     ? StressMeasure::cauchy
                   : stress == "tau" ? StressMeasure::kirchhoff
                                     : StressMeasure::first_piola_kirchhoff;
  return found;
}

const char* letter_of(Deformation deformation) {
  return deformation == Deformation::gradient ? "F" : deformation == Deformation::logarithmic_strain ? "e" : "L";
}

const char* letter_of(StressMeasure stress) {
  return stress == StressMeasure::cauchy ? "s" : stress == StressMeasure::kirchhoff ? "tau" : "P";
}

ControlQuantity control_quantity(const PathQuantity& quantity, Deformation deformation) {
  ControlQuantity found;
  for (const PathTerm& term : quantity.terms) {
    if (!term.of_J()) {
      (term.of_stress() ? found.stress : found.deformation)(term.i, term.j) += term.factor;
    } else if (term.family == "J") {
      found.J += term.factor;
    } else if (deformation == Deformation::gradient) {
      found.ln_J += term.factor;
    } else {
      found.deformation += term.factor * Tensor::Identity();
    }
  }
  return found;
}

}  // namespace assay::drivers
