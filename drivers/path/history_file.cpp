// SPDX-License-Identifier: BSD-3-Clause
// Histories from CSV files: a column of times, and one of values; units may stand behind the names.
#include <algorithm>

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

/// Of a column. The unit of its header wins over `unit`, the one that the scene says.
Scale scale_of_column(const std::string& text, HistoryKind kind, const std::string& unit, const Location& where) {
  if (kind == HistoryKind::field) return {};
  const std::string own = heading_of(text).unit, word = own.empty() ? unit : own;
  const KindWords& kinds = words_of_kind(kind);
  const auto parsed = parse_unit(word);
  if (parsed && parsed->dimension == parse_unit(kinds.si)->dimension) return parsed->scale;
  throw InputError(where, "", "'" + word + "' of the column '" + text + "' is no unit of " + kinds.noun,
                   joined(kinds.known));
}

}  // namespace

const char* si_unit_of(HistoryKind kind) { return words_of_kind(kind).si; }

void read_history_file(PathFunction& f, const std::string& name, const std::string& key, HistoryKind kind,
                       const Units& units, HistoryKind time_kind) {
  if (f.unit.empty()) f.unit = units.name(si_unit_of(kind));
  if (f.time_unit.empty()) f.time_unit = units.name(si_unit_of(time_kind));
  const std::string text = read_input_file(f.file), wanted = f.column.empty() ? name : f.column;
  CsvLines lines(text, f.file);
  const auto header = lines.next();
  if (!header) throw InputError({f.file, 0, 0}, "", "is empty");
  std::vector<std::string> names, plain;
  for (const CsvField& field : *header) {
    names.push_back(field.text);
    plain.push_back(heading_of(field.text).name);
  }
  const auto column_of = [&](const std::string& column, const char* option) {
    for (const auto* list : {&names, &plain}) {
      const auto found = std::find(list->begin(), list->end(), column);
      if (found != list->end()) return static_cast<std::size_t>(found - list->begin());
    }
    throw InputError(f.where, key_path(key, option), "'" + f.file + "' has no column '" + column + "'", joined(plain));
  };
  const std::size_t times = column_of(f.time, "time"), values = column_of(wanted, "column");
  const Location head{f.file, lines.line(), 1};
  const Scale time_scale = scale_of_column(names[times], time_kind, f.time_unit, head);
  const Scale value_scale = scale_of_column(names[values], kind, f.unit, head);
  const CsvTable table = read_csv(text, f.file, {names[times], names[values]}, [&] {
    std::vector<std::string> others = names;
    std::erase(others, names[times]), std::erase(others, names[values]);
    return others;
  }());
  f.times.clear(), f.values.clear();
  const auto refuse = [&](std::size_t row, const std::string& what) {
    throw InputError({f.file, table.lines[row], 1}, f.time, what);
  };
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double t = time_scale.to_si((*table.column(names[times]))[i]);
    if (i == 0 && t < 0) refuse(i, "times must not be negative");
    if (i > 0 && t < f.times.back())
      refuse(i, "times must ascend, found " + units.text(t, si_unit_of(time_kind)) + " after " +
                    units.text(f.times.back(), si_unit_of(time_kind)));
    if (i > 1 && t == f.times[i - 2]) refuse(i, "three rows at one time");
    f.times.push_back(t);
    f.values.push_back(value_scale.to_si((*table.column(names[values]))[i]) * f.factor + f.offset);
  }
  if (f.times.size() < 2) throw InputError({f.file, table.header_line, 1}, "", "a history needs two rows at least");
  if (f.times.front() == f.times.back()) refuse(f.times.size() - 1, "all rows are at one time");
}

}  // namespace assay::drivers
