// SPDX-License-Identifier: BSD-3-Clause
// Evolutions, external and internal state variables of an MTest file.
#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

std::string new_evolution_name(MtestTokens& tokens) {
  const Location where = tokens.where();
  std::string name = tokens.text();
  if (name == "t") tokens.refuse(where, "'t' is the time");
  if (is_one_of(name, mtest_functions())) tokens.refuse(where, "'" + name + "' is a function of formulas");
  return name;
}

void read_real(MtestReading& reading) {
  const Location where = reading.tokens.where();
  const std::string name = new_evolution_name(reading.tokens);
  reading.evolutions.add(name, constant_in_time(read_number(reading)), where);
  reading.tokens.expect(";");
}

void read_evolution(MtestReading& reading) {
  const std::string type = read_type(reading);
  const Location where = reading.tokens.where();
  const std::string name = new_evolution_name(reading.tokens);
  reading.evolutions.add(name, read_function(reading, type), where);
  reading.tokens.expect(";");
}

/// Whether braces hold functions, one for each component, and not the points of a table.
bool next_is_list(const MtestTokens& tokens) {
  if (!tokens.next_is("{")) return false;
  std::size_t ahead = 1;
  if (tokens.peek(ahead).kind == MtestToken::Kind::sign && tokens.peek(ahead).text != "{") ++ahead;
  return tokens.peek(ahead + 1).text != ":";
}

/// The ends of the names of so many components.
std::vector<std::string> ends_of(const MtestReading& reading, std::size_t count, const Location& where) {
  const MtestHypothesis& hypothesis = reading.hypothesis();
  for (const auto* ends : {&hypothesis.vector, &hypothesis.symmetric, &hypothesis.general})
    if (ends->size() == count) return *ends;
  reading.tokens.refuse(
      where, std::to_string(count) + " values make no vector or tensor of the hypothesis " + hypothesis.name);
}

void add_external(MtestReading& reading, const std::string& name, const FunctionOfTime& value, const Location& where) {
  reading.evolutions.add(name, value, where);
  reading.out.external.push_back({name, value, where});
}

void read_external(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const std::string type = read_type(reading);
  const Location where = tokens.where();
  const std::string name = tokens.text();
  if (next_is_list(tokens)) {
    std::vector<FunctionOfTime> values;
    tokens.expect("{");
    do values.push_back(read_function(reading, type));
    while (tokens.take(","));
    tokens.expect("}");
    const std::vector<std::string> ends = ends_of(reading, values.size(), where);
    for (std::size_t i = 0; i < values.size(); ++i) add_external(reading, name + ends[i], values[i], where);
  } else {
    add_external(reading, name, read_function(reading, type), where);
  }
  tokens.expect(";");
}

void read_internal(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  MtestInitialValue value;
  value.where = tokens.where();
  value.name = tokens.text();
  value.in_braces = tokens.next_is("{");
  value.values = value.in_braces ? read_numbers(reading) : std::vector<double>{read_number(reading)};
  reading.out.initial_state.push_back(std::move(value));
  tokens.expect(";");
}

}  // namespace

void add_variable_keywords(MtestHandlers& handlers) {
  handlers["@Real"] = read_real;
  handlers["@Evolution"] = read_evolution;
  handlers["@ExternalStateVariable"] = read_external;
  handlers["@InternalStateVariable"] = read_internal;
  handlers["@StateVariable"] = read_internal;
}

}  // namespace assay::drivers
