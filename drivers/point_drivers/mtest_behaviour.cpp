// SPDX-License-Identifier: BSD-3-Clause
// @Behaviour, @Model, hypothesis, material properties and parameters of an MTest file.
#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// A text, a word, a number, or several in braces as "a, b".
std::string read_option(MtestTokens& tokens) {
  if (tokens.next_is_text()) return tokens.text();
  if (!tokens.take("{")) return tokens.peek().kind == MtestToken::Kind::number ? tokens.next().text : tokens.word();
  std::vector<std::string> values;
  do values.push_back(tokens.next_is_text() ? tokens.text() : tokens.next().text);
  while (tokens.take(","));
  tokens.expect("}");
  return joined(values);
}

void read_named_behaviour(MtestReading& reading, bool is_model) {
  MtestTokens& tokens = reading.tokens;
  MtestBehaviour& behaviour = reading.out.behaviour;
  if (!behaviour.function.empty())
    tokens.refuse("the behaviour is there already, in line " + std::to_string(behaviour.where.line));
  behaviour.where = tokens.where();
  behaviour.is_model = is_model;
  if (tokens.take("<")) {
    behaviour.interface = tokens.word();
    if (tokens.take(",")) behaviour.wrapper = tokens.word();
    tokens.expect(">");
  }
  behaviour.library = tokens.text();
  behaviour.function = tokens.text();
  if (behaviour.function.empty()) tokens.refuse(behaviour.where, "the behaviour has no name");
  if (tokens.next_is("{")) {
    read_map(tokens, [&](const std::string& name, const Location&) { behaviour.options[name] = read_option(tokens); });
  }
  tokens.expect(";");
}

void read_hypothesis(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  const std::string name = tokens.text();
  if (!find_hypothesis(name))
    tokens.refuse(where, unknown("hypothesis", name, hypothesis_names()), joined(hypothesis_names()));
  reading.out.hypothesis = name;
  tokens.expect(";");
}

void read_property(MtestReading& reading) {
  static const std::vector<std::string> libraries{"generic", "Generic", "castem", "Castem", "cyrano", "Cyrano"};
  MtestTokens& tokens = reading.tokens;
  const Location of_type = tokens.where();
  const std::string type = read_type(reading);
  MtestProperty property;
  property.where = tokens.where();
  property.name = tokens.text();
  if (is_one_of(type, libraries)) {
    MtestLibraryFunction function{small_letters(type), tokens.text(), {}};
    function.function = tokens.text();
    property.computed_by = function;
    reading.evolutions.add_unknown(property.name, property.where);
  } else if (type == "constant" || type == "function") {
    property.value = read_function(reading, type == "function" ? type : "");
    reading.evolutions.add(property.name, property.value, property.where);
  } else {
    tokens.refuse(of_type, "a property is <constant>, <function>, or of a library",
                  "constant, function, " + joined(libraries));
  }
  reading.out.properties.push_back(property);
  tokens.expect(";");
}

void read_parameter(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  MtestParameter parameter;
  parameter.where = tokens.where();
  parameter.name = tokens.text();
  parameter.value = read_number(reading);
  reading.out.parameters.push_back(parameter);
  tokens.expect(";");
}

void read_whole_parameter(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  MtestParameter parameter;
  parameter.where = tokens.where();
  parameter.name = tokens.text();
  const bool minus = tokens.take("-");
  parameter.value = minus ? -tokens.count() : tokens.count();
  reading.out.parameters.push_back(parameter);
  tokens.expect(";");
}

void read_bounds_policy(MtestReading& reading) {
  static const std::vector<std::string> known{"None", "Warning", "Strict"};
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  const std::string policy = tokens.text();
  if (!is_one_of(policy, known)) tokens.refuse(where, unknown("policy", policy, known), joined(known));
  reading.out.out_of_bounds = policy;
  if (policy == "Strict")
    reading.out.ignored.push_back({"@OutOfBoundsPolicy", "'Strict': only physical bounds are served", where});
  tokens.expect(";");
}

void read_thermal_expansion(MtestReading& reading) {
  reading.out.thermal_expansion = reading.tokens.yes_or_no();
  reading.tokens.expect(";");
}

}  // namespace

void add_behaviour_keywords(MtestHandlers& handlers) {
  handlers["@Behaviour"] = [](MtestReading& reading) { read_named_behaviour(reading, false); };
  handlers["@Model"] = [](MtestReading& reading) { read_named_behaviour(reading, true); };
  handlers["@ModellingHypothesis"] = read_hypothesis;
  handlers["@MaterialProperty"] = read_property;
  handlers["@Parameter"] = read_parameter;
  handlers["@IntegerParameter"] = read_whole_parameter;
  handlers["@UnsignedIntegerParameter"] = read_whole_parameter;
  handlers["@OutOfBoundsPolicy"] = read_bounds_policy;
  handlers["@HandleThermalExpansion"] = read_thermal_expansion;
}

}  // namespace assay::drivers
