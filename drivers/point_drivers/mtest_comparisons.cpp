// SPDX-License-Identifier: BSD-3-Clause
// What an MTest file expects: formulas, and columns of files.
#include <set>

#include "drivers/point_drivers/mtest_reading.hpp"
#include "drivers/point_drivers/number_columns.hpp"

namespace assay::drivers {

namespace {

/// The column of a comparison with a file: 2, or "$2*1e6" in quotes.
void read_place(MtestReading& reading, MtestComparison& comparison) {
  MtestTokens& tokens = reading.tokens;
  if (tokens.next_is_text()) {
    comparison.column_formula = tokens.text();
    return;
  }
  comparison.column = tokens.count();
  if (comparison.column < 1) tokens.refuse(comparison.where, "columns count from 1");
}

void read_comparison(MtestReading& reading) {
  MtestTokens& tokens = reading.tokens;
  const Location of_type = tokens.where();
  const std::string type = read_type(reading);
  if (type != "function" && type != "file") tokens.refuse(of_type, "write @Test<function> or @Test<file>");
  const std::string file = type == "file" ? mtest_path(reading.out.file, tokens.text()) : "";
  std::vector<MtestComparison> found;
  const auto read_expected = [&](const std::string& variable, const Location& where) {
    MtestComparison& comparison = found.emplace_back();
    comparison.variable = variable, comparison.where = where, comparison.file = file;
    if (type == "file") {
      read_place(reading, comparison);
    } else {
      comparison.expected = read_function(reading, "function");
    }
  };
  if (tokens.next_is_text()) {
    const Location where = tokens.where();
    const std::string variable = tokens.text();
    read_expected(variable, where);
  } else {
    read_map(tokens, read_expected);
  }
  const Location of_tolerance = tokens.where();
  const double tolerance = read_number(reading);
  if (tolerance < 0) tokens.refuse(of_tolerance, "the tolerance must not be negative");
  std::set<std::string> named;
  for (MtestComparison& each : found) {
    if (!named.insert(each.variable).second) {
      reading.out.ignored.push_back(
          {"@Test", "'" + each.variable + "' stands there twice: the first counts", each.where});
      continue;
    }
    each.tolerance = tolerance;
    reading.out.comparisons.push_back(std::move(each));
  }
  tokens.expect(";");
}

}  // namespace

void add_comparison_keywords(MtestHandlers& handlers) { handlers["@Test"] = read_comparison; }

std::vector<double> expected_lines(const MtestFile& file, const MtestComparison& comparison) {
  const std::vector<NumberLine> lines = number_lines(read_table_bytes(comparison.file));
  if (comparison.column > 0) return column_values(lines, comparison.column, comparison.file);
  const auto constant = [&](const std::string& name) {
    const auto found = file.evolutions.find(name);
    if (found == file.evolutions.end() || !found->second || !found->second.is_constant())
      throw InputError(comparison.where, "@Test", "'" + name + "' is no column and no constant");
    return found->second(0);
  };
  return formula_of_columns(lines, comparison.column_formula, comparison.file, comparison.where, constant);
}

}  // namespace assay::drivers
