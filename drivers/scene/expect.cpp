// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/expect.hpp"

#include <algorithm>
#include <utility>

#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

using Operator = Expectation::Operator;

void read_comparison(const Tree& map, const std::string& path, Expectation& line) {
  const std::vector<std::string> operators = words_of<Operator>();
  refuse_unknown_keys(map, path, operators);
  if (map.entries.size() != 1) throw InputError(map.where, path, "must hold exactly one operator", joined(operators));
  const auto& [name, name_where, value] = map.entries.front();
  line.op = static_cast<Operator>(index_of(name, operators));
  const std::string operator_path = key_path(path, name);
  if (line.op == Operator::between) {
    const std::vector<double> bounds = numbers_value(value, operator_path, 1, 2);
    line.number = bounds[0], line.upper = bounds[1];
    if (!(line.number <= line.upper))
      throw InputError(value.where, operator_path, "the first must not exceed the second");
  } else {
    line.number = number_value(value, operator_path);
  }
}

/// The value itself, or the one of {equals: value}.
const Tree& equalled(const Tree& value, const std::string& path, const std::string& what) {
  if (value.kind != Tree::Kind::map) return value;
  refuse_unknown_keys(value, path, {"equals"});
  const Tree* equals = value.find("equals");
  if (!equals) throw InputError(value.where, path, "must be " + what);
  return *equals;
}

Expectation read_line(const Tree::Entry& entry, const ExpectationWords& words) {
  const std::string path = key_path(words.path, entry.key);
  Expectation line;
  line.key = entry.key;
  line.where = entry.key_where;
  const Field::Kind kind = figure_of_result(entry.key).kind;
  const bool is_outcome = entry.key == "outcome" || entry.key.ends_with(".outcome");
  if (kind == Field::Kind::text || is_outcome) {
    const Tree& value = equalled(entry.value, path, "text or {equals: text}");
    line.text = is_outcome ? choice_value(value, path, words.outcomes) : text_value(value, path);
  } else if (kind == Field::Kind::truth) {
    line.truth = boolean_value(equalled(entry.value, path, "true, false, {equals: true} or {equals: false}"), path);
  } else if (entry.value.kind == Tree::Kind::map) {
    read_comparison(entry.value, path, line);
  } else if (entry.value.kind == Tree::Kind::sequence) {
    throw InputError(entry.value.where, path, "must be a number or a map with one operator, found a list",
                     joined(words_of<Operator>()));
  } else {
    line.number = number_value(entry.value, path);
  }
  return line;
}

bool holds(const Expectation& line, double found) {
  if (line.op == Operator::between) return line.number <= found && found <= line.upper;
  return line.op == Operator::below   ? found < line.number
         : line.op == Operator::above ? found > line.number
                                      : found == line.number;
}

std::string expected_text(const Expectation& line, const AuthorUnit& unit = {}) {
  if (line.text) return *line.text;
  if (line.truth) return *line.truth ? "true" : "false";
  const std::string name = word_of(line.op);
  if (line.op == Operator::between) return name + " " + unit.number(line.number) + " and " + unit.text(line.upper);
  return name + " " + unit.text(line.number);
}

constexpr int author_digits = 6;  ///< of a figure that was converted

/// An error of the response beyond both says that its figures say nothing.
constexpr double largest_response_error = 0.05, times_asked = 100;

/// The lines that no scene need say, of those errors that are known.
std::vector<Expectation> of_any_response(const SheetFigures& response) {
  std::vector<Expectation> lines;
  const std::pair<const char*, Figure> errors[] = {{"sheet.error_tau", response.error_tau},
                                                   {"sheet.error_dtau", response.error_dtau}};
  for (const auto& [key, error] : errors) {
    if (!error) continue;
    lines.emplace_back().key = key;
    lines.back().op = Operator::below;
    lines.back().number = std::max(largest_response_error, times_asked * response.asked);
  }
  return lines;
}

}  // namespace

const std::vector<std::string>& known_outcomes() {
  static const std::vector<std::string> names{"completed", "unstable", "material_failed", "refused"};
  return names;
}

bool is_of_order(const Expectation& line) { return line.key == order_key || line.key == last_order_key; }

// weak: libassay has another in its place
[[gnu::weak]] std::vector<Expectation> read_expectations(const Tree& map, const ExpectationWords& words) {
  std::vector<std::string> known = words.numbers;
  append_all(known, words.of_runs ? flat_keys() : std::vector<std::string>{"outcome"});
  require_map(map, words.path, "keys of result.json");
  refuse_unknown_keys(map, words.path, known);
  return mapped(map.entries, [&](const Tree::Entry& entry) {
    Expectation line = read_line(entry, words);
    if (!words.of_runs || line.text || line.truth) return line;  // those of a path stay in the author's units
    const Scale scale = author_unit(line.key, words.units).scale;
    line.number = scale.to_si(line.number), line.upper = scale.to_si(line.upper);
    return line;
  });
}

std::string expectation_yaml(const Expectation& line) {
  if (line.text) return yaml_scalar(*line.text);
  if (line.truth) return expected_text(line);
  const std::string name = word_of(line.op);
  if (line.op == Operator::between) {
    return "{between: [" + yaml_number(line.number) + ", " + yaml_number(line.upper) + "]}";
  }
  return "{" + name + ": " + yaml_number(line.number) + "}";
}

std::string AuthorUnit::number(double si) const {
  return scale.is_one() ? number_text(si) : rounded_text(scale.from_si(si), author_digits);
}

std::string AuthorUnit::text(double si) const { return number(si) + (scale.is_one() ? "" : " " + name); }

AuthorUnit author_unit(const std::string& key, const Units& units) {
  if (units.is_si() || is_one_of(key, {order_key, last_order_key})) return {};
  const std::string si = figure_of_result(key).unit;
  return {units.scale(si), units.name(si)};
}

ExpectationOutcome judged(const Expectation& line, const FlatValue& found, const AuthorUnit& unit) {
  ExpectationOutcome outcome{line.key, expected_text(line, unit), "null", false};
  if (const auto* text = std::get_if<std::string>(&found)) {
    outcome.found = *text;
    outcome.holds = line.text && *line.text == *text;
  } else if (const auto* truth = std::get_if<bool>(&found)) {
    outcome.found = *truth ? "true" : "false";
    outcome.holds = line.truth && *line.truth == *truth;
  } else if (const auto* number = std::get_if<double>(&found)) {
    outcome.found = unit.text(*number);
    outcome.holds = !line.text && !line.truth && holds(line, *number);
  }
  return outcome;
}

std::vector<ExpectationOutcome> judge(const std::vector<Expectation>& expectations, const Result& result) {
  const auto figures = flatten(result);
  std::vector<ExpectationOutcome> outcomes;
  for (const Expectation& line : expectations) {
    if (is_of_order(line)) continue;
    const auto found = figures.find(line.key);
    outcomes.push_back(
        judged(line, found == figures.end() ? FlatValue{} : found->second, author_unit(line.key, result.units)));
  }
  for (const Expectation& line : result.sheet ? of_any_response(*result.sheet) : std::vector<Expectation>()) {
    const auto same = [&](const ExpectationOutcome& e) { return e.key == line.key; };
    ExpectationOutcome outcome = judged(line, figures.at(line.key));
    outcome.expected += ", as of any response";
    if (!outcome.holds && std::none_of(outcomes.begin(), outcomes.end(), same)) outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

std::vector<Expectation> expected_again(const Result& result) {
  std::vector<Expectation> lines(1);
  lines[0].key = "outcome";
  lines[0].text = result.outcome;
  const auto figures = flatten(result);
  for (Expectation& line : result.sheet ? of_any_response(*result.sheet) : std::vector<Expectation>()) {
    if (judged(line, figures.at(line.key)).holds) continue;
    line.op = Operator::above;
    lines.push_back(line);
  }
  return lines;
}

}  // namespace assay::drivers
