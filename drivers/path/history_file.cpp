// SPDX-License-Identifier: BSD-3-Clause
// Histories from CSV files: a column of times, and one of values; units may stand behind the names.
#include <algorithm>
#include <map>
#include <sstream>

#include "drivers/format/csv.hpp"
#include "drivers/path/path_function.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// What values of a kind are: a noun, their SI unit, and units that people write.
struct KindWords {
  const char *noun, *si;
  std::vector<std::string> known;
};
const KindWords& words_of_kind(HistoryKind kind) {
  static const std::vector<KindWords> all{
      {"a stress", "Pa", {"Pa", "kPa", "MPa", "GPa", "N/mm2", "N/mm^2", "bar", "psi", "ksi"}},
      {"a number", "1", {"1", "-", "%", "mm/mm", "m/m", "um/m"}},
      {"a time", "s", {"s", "ms", "us", "min", "h"}},
      {"a rate", "1/s", {"1/s", "1/min", "1/h"}},
      {"a field", "1", {}}};
  return all[static_cast<std::size_t>(kind)];
}

/// A column of a file: where it stands, and the unit that its header says.
struct Column {
  std::size_t index = 0;
  std::string text, unit;
};

/// Units of columns as `assay tabulate` writes them, before the header: "# units: t [s], e11 [1]".
std::map<std::string, std::string> units_of_remark(const std::string& text) {
  std::map<std::string, std::string> units;
  const std::string mark = "# units:";
  if (!text.starts_with(mark)) return units;
  std::istringstream words(text.substr(mark.size(), text.find('\n') - mark.size()));
  for (std::string word; std::getline(words, word, ',');) {
    const Heading heading = heading_of(std::string(stripped(word)));
    if (!heading.unit.empty()) units[heading.name] = heading.unit;
  }
  return units;
}

/// The numbers of a column in SI. `said`: by the scene, empty where it says nothing, and afterwards the unit in use.
Scale scale_of_column(const Column& column, HistoryKind kind, const Units& units, std::string& said,
                      const Location& where, const Location& said_where, const std::string& said_key) {
  const KindWords& kinds = words_of_kind(kind);
  const auto scale_of = [&](const std::string& word, const Location& at, const std::string& key,
                            const std::string& what) {
    const auto parsed = parse_unit(word);
    if (parsed && parsed->dimension == parse_unit(kinds.si)->dimension) return parsed->scale;
    throw InputError(at, key, "'" + one_line(word, 40) + "'" + what + " is no unit of " + kinds.noun,
                     joined(kinds.known));
  };
  const std::string of_column = " of the column '" + one_line(column.text, 80) + "'";
  if (kind == HistoryKind::field) {
    if (!said.empty())
      throw InputError(said_where, said_key, "has no effect: a field is in the unit that the model has for it");
    const auto parsed = parse_unit(column.unit);
    const bool of_other = parsed && (parsed->dimension.stress != 0 || parsed->dimension.time != 0);
    if (of_other) throw InputError(where, "", "'" + column.unit + "'" + of_column + " is no unit of " + kinds.noun);
    return {};
  }
  const bool is_said = !said.empty();
  if (!is_said) said = column.unit.empty() ? units.name(kinds.si) : column.unit;
  const Scale scale = scale_of(said, is_said ? said_where : where, is_said ? said_key : "", is_said ? "" : of_column);
  if (!is_said || column.unit.empty() || scale_of(column.unit, where, "", of_column) == scale) return scale;
  throw InputError(said_where, said_key,
                   "is '" + said + "', and the header of the file says '" + column.unit + "': leave it out");
}

}  // namespace

const char* si_unit_of(HistoryKind kind) { return words_of_kind(kind).si; }

void read_history_file(PathFunction& f, const std::string& name, const std::string& key, HistoryKind kind,
                       const Units& units, HistoryKind time_kind) {
  const std::string text = read_input_file(f.file), wanted = f.column.empty() ? name : f.column;
  CsvLines lines(text, f.file);
  const auto header = lines.next();
  if (!header) throw InputError({f.file, 0, 0}, "", "is empty");
  std::vector<std::string> names, plain;
  for (const CsvField& field : *header) {
    names.push_back(field.text);
    plain.push_back(heading_of(field.text).name);
  }
  const auto remark = units_of_remark(text);
  const bool compares = key == "compare";  // whose keys have names of their own
  const auto column_of = [&](const std::string& column, const char* option) {
    for (const auto* list : {&names, &plain}) {
      const auto found = std::find(list->begin(), list->end(), column);
      if (found == list->end()) continue;
      const auto k = static_cast<std::size_t>(found - list->begin());
      const auto remarked = remark.find(plain[k]);
      const std::string unit = heading_of(names[k]).unit;
      return Column{k, names[k], unit.empty() && remarked != remark.end() ? remarked->second : unit};
    }
    throw InputError(f.where, key_path(key, option), "'" + f.file + "' has no column '" + column + "'", joined(plain));
  };
  const Column time_column = column_of(f.time, compares ? "x_column" : "time");
  const Column value_column = column_of(wanted, compares ? "y_column" : "column");
  const std::size_t times = time_column.index, values = value_column.index;
  const Location head{f.file, lines.line(), 1};
  const Scale time_scale = scale_of_column(time_column, time_kind, units, f.time_unit, head, f.where,
                                           key_path(key, compares ? "x_unit" : "time_unit"));
  const Scale value_scale =
      scale_of_column(value_column, kind, units, f.unit, head, f.where, key_path(key, compares ? "y_unit" : "unit"));
  const CsvTable table = read_csv(text, f.file, {names[times], names[values]}, [&] {
    std::vector<std::string> others = names;
    std::erase(others, names[times]), std::erase(others, names[values]);
    return others;
  }());
  const bool of_time = time_kind == HistoryKind::time;
  const auto refuse = [&](std::size_t row, const std::string& what) {
    throw InputError({f.file, table.lines[row], 1}, f.time, what);
  };
  std::vector<double> at, found;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    at.push_back(time_scale.to_si((*table.column(names[times]))[i]));
    found.push_back(value_scale.to_si((*table.column(names[values]))[i]) * f.factor + f.offset);
  }
  if (of_time && !at.empty() && at[0] < 0) refuse(0, "times must not be negative");
  const bool falls = !of_time && at.size() > 1 && at.back() < at.front();
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (falls ? at[i] > at[i - 1] : at[i] < at[i - 1]) {
      const auto words = [&](double x) {
        return rounded_text(time_scale.from_si(x), 6) + (f.time_unit == "1" ? "" : " " + f.time_unit);
      };
      refuse(i, (of_time ? std::string("times must ascend") : "must rise or fall all along") + ", found " +
                    words(at[i]) + " after " + words(at[i - 1]));
    }
    if (i > 1 && at[i] == at[i - 2]) refuse(i, of_time ? "three rows at one time" : "three rows at one value");
  }
  if (falls) std::ranges::reverse(at), std::ranges::reverse(found);
  f.times = std::move(at), f.values = std::move(found);
  if (f.times.size() < 2) throw InputError({f.file, table.header_line, 1}, "", "a history needs two rows at least");
  if (f.times.front() == f.times.back()) refuse(f.times.size() - 1, "all rows are at one time");
}

}  // namespace assay::drivers
