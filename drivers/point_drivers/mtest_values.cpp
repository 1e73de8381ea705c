// SPDX-License-Identifier: BSD-3-Clause
// Numbers, functions of time and times of an MTest file.
#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/point_drivers/number_columns.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

constexpr int most_times = 10'000'000;

FunctionOfTime read_table(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  std::map<double, double> points;
  tokens.expect("{");
  do {
    const Location where = tokens.where();
    const double time = read_number(reading);
    tokens.expect(":");
    if (!points.emplace(time, read_number(reading)).second)
      tokens.refuse(where, "the time " + number_text(time) + " is there twice");
  } while (tokens.take(","));
  tokens.expect("}");
  return table_in_time(points);
}

FunctionOfTime read_columns(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location where = tokens.where();
  const std::string file = mtest_path(reading.out.file, tokens.text());
  if (tokens.word() != "using") tokens.refuse(where, "write 'file' using 1:2, the columns of time and value");
  const std::vector<double> times = read_column(reading, file);
  tokens.expect(":");
  const std::vector<double> values = read_column(reading, file);
  std::map<double, double> points;
  for (std::size_t i = 0; i < times.size(); ++i) points.emplace(times[i], values[i]);
  if (points.empty()) tokens.refuse(where, "'" + file + "' holds no lines of numbers");
  return table_in_time(points);
}

}  // namespace

Location inside_quotes(const MtestTokens& tokens) {
  Location where = tokens.where();
  if (tokens.peek().kind == MtestToken::Kind::text) ++where.column;
  return where;
}

double read_number(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  if (!tokens.next_is_text()) return tokens.number();
  const Location where = inside_quotes(tokens);
  const std::string formula = tokens.text();
  return reading.evolutions.constant(formula, where);
}

std::vector<double> read_numbers(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  std::vector<double> values;
  int depth = 0;
  tokens.expect("{");
  for (++depth; depth > 0;) {
    while (tokens.take("{")) ++depth;
    values.push_back(read_number(reading));
    while (depth > 0 && tokens.take("}")) --depth;
    if (depth > 0) tokens.expect(",");
  }
  return values;
}

std::string read_type(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  if (!tokens.take("<")) return {};
  std::string type = tokens.word();
  tokens.expect(">");
  return type;
}

FunctionOfTime read_function(MtestReading& reading, const std::string& type) {
  MtestTokens& tokens = reading.tokens;
  if (type == "function") {
    const Location where = inside_quotes(tokens);
    const std::string formula = tokens.text();
    return reading.evolutions.of_formula(formula, where);
  }
  if (type == "data" || type == "file") return read_columns(reading);
  if (!type.empty() && type != "evolution")
    tokens.refuse("'" + type + "' is no kind of a function of time", "evolution, function, data, file");
  return tokens.next_is("{") ? read_table(reading) : constant_in_time(read_number(reading));
}

std::vector<double> read_times(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  std::vector<double> times;
  tokens.expect("{");
  do {
    const Location where = tokens.where();
    const double time = read_number(reading);
    if (!times.empty()) {
      const double last = times.back();
      const double eps = 100 * std::numeric_limits<double>::epsilon() * std::max(std::abs(last), std::abs(time));
      if (!(time - last > eps)) tokens.refuse(where, "the times must ascend");
      if (tokens.peek().kind == MtestToken::Kind::word && tokens.peek().text == "in") {
        tokens.next();
        const Location of_count = tokens.where();
        const int intervals = tokens.count();
        if (intervals < 1) tokens.refuse(of_count, "at least one interval");
        if (intervals > most_times) tokens.refuse(of_count, "too many times");
        for (int i = 1; i < intervals; ++i) times.push_back(last + i * ((time - last) / intervals));
      }
    }
    times.push_back(time);
    if (times.size() > most_times) tokens.refuse(where, "too many times");
  } while (tokens.take(","));
  tokens.expect("}");
  return times;
}

std::vector<double> read_column(MtestReading& reading, const std::string& file) {
  MtestTokens& tokens = reading.tokens;
  const Location where = inside_quotes(tokens);
  const std::string formula = tokens.next_is_text() ? tokens.text() : "";
  const int column = formula.empty() ? tokens.count() : 0;
  if (formula.empty() && column < 1) tokens.refuse(where, "columns count from 1");
  const std::vector<NumberLine> lines = number_lines(read_table_bytes(file));
  if (column > 0) return column_values(lines, column, file);
  return formula_of_columns(lines, formula, file, where,
                            [&](const std::string& name) { return reading.evolutions.constant(name, where); });
}

void read_map(MtestTokens& tokens, const std::function<void(const std::string& name, const Location& where)>& take) {
  tokens.expect("{");
  if (tokens.take("}")) return;
  do {
    const Location where = tokens.where();
    const std::string name = tokens.next_is_text() ? tokens.text() : tokens.word();
    tokens.expect(":");
    take(name, where);
  } while (tokens.take(","));
  tokens.expect("}");
}

}  // namespace assay::drivers
