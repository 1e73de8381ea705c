// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/point_drivers/number_columns.hpp"

#include <algorithm>

#include "drivers/point_drivers/mtest_formula.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

constexpr std::size_t largest_table = std::size_t{1} << 28;  // [bytes]

/// Of "$12" 12; 0 of another name.
int number_of_column(const std::string& name) {
  if (name.size() < 2 || name[0] != '$') return 0;
  const auto number = parse_integer(name.substr(1));
  return number && *number > 0 && *number < 1000000 ? static_cast<int>(*number) : 0;
}

}  // namespace

std::vector<NumberLine> number_lines(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<NumberLine> lines;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    NumberLine fields;
    fields.line = ++number;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos; at = line.find_first_not_of(blanks, at)) {
      if (line[at] == '#') break;
      const std::size_t last = std::min(line.find_first_of(blanks, at), line.size());
      fields.columns.push_back(static_cast<int>(at) + 1);
      fields.fields.emplace_back(line.substr(at, last - at));
      at = last;
    }
    if (!fields.fields.empty()) lines.push_back(std::move(fields));
  }
  return lines;
}

std::vector<double> column_values(const std::vector<NumberLine>& lines, int column, const std::string& file) {
  std::vector<double> values;
  const auto index = static_cast<std::size_t>(column - 1);
  for (const NumberLine& line : lines) {
    if (index >= line.fields.size())
      throw InputError({file, line.line, 1}, "",
                       "has no column " + std::to_string(column) + ", only " + std::to_string(line.fields.size()));
    const auto value = parse_number(line.fields[index]);
    if (!value)
      throw InputError({file, line.line, line.columns[index]}, "", "'" + line.fields[index] + "' is no number");
    values.push_back(*value);
  }
  return values;
}

std::vector<double> formula_of_columns(const std::vector<NumberLine>& lines, const std::string& text,
                                       const std::string& file, const Location& where,
                                       const std::function<double(const std::string& name)>& constant) {
  const MtestFormula formula(text, where);
  std::vector<std::vector<double>> columns;
  bool has_column = false;
  for (const std::string& name : formula.variables()) {
    const int number = number_of_column(name);
    has_column = has_column || number > 0;
    columns.push_back(number > 0 ? column_values(lines, number, file)
                                 : std::vector<double>(lines.size(), constant(name)));
  }
  if (!has_column) throw InputError(where, "", "'" + text + "' names no column: write $2 for the second one");
  std::vector<double> values;
  for (std::size_t i = 0; i < lines.size(); ++i)
    values.push_back(formula.value(mapped(columns, [i](const std::vector<double>& column) { return column[i]; })));
  return values;
}

std::string read_table_bytes(const std::string& file) { return read_bytes(file, largest_table); }

}  // namespace assay::drivers
