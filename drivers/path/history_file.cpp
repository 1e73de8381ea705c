// SPDX-License-Identifier: BSD-3-Clause
// Histories from CSV files: a column of times, and one of values; units may stand behind the names.
#include <algorithm>

#include "drivers/format/csv.hpp"
#include "drivers/path/path_function.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// A header as people write them: "stress [MPa]", "stress (MPa)", "stress / MPa".
struct Heading {
  std::string name, unit;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, last - first + 1);
}

Heading heading_of(const std::string& text) {
  for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
    const std::size_t at = text.rfind(open);
    if (at != text.npos && at > 0 && text.back() == close)
      return {trimmed(text.substr(0, at)), trimmed(text.substr(at + 1, text.size() - at - 2))};
  }
  const std::size_t slash = text.rfind('/');
  if (slash != text.npos && slash > 0 && slash + 1 < text.size())
    return {trimmed(text.substr(0, slash)), trimmed(text.substr(slash + 1))};
  return {trimmed(text), ""};
}

/// What a unit measures, and SI units in one of it.
struct KnownUnit {
  const char* name;
  HistoryKind kind;
  double factor;
};
constexpr KnownUnit known_units[] = {{"Pa", HistoryKind::stress, 1},
                                     {"kPa", HistoryKind::stress, 1e3},
                                     {"MPa", HistoryKind::stress, 1e6},
                                     {"GPa", HistoryKind::stress, 1e9},
                                     {"N/mm2", HistoryKind::stress, 1e6},
                                     {"N/mm^2", HistoryKind::stress, 1e6},
                                     {"bar", HistoryKind::stress, 1e5},
                                     {"psi", HistoryKind::stress, 6894.757293168361},
                                     {"ksi", HistoryKind::stress, 6894757.293168361},
                                     {"1", HistoryKind::number, 1},
                                     {"-", HistoryKind::number, 1},
                                     {"%", HistoryKind::number, 1e-2},
                                     {"mm/mm", HistoryKind::number, 1},
                                     {"m/m", HistoryKind::number, 1},
                                     {"um/m", HistoryKind::number, 1e-6},
                                     {"s", HistoryKind::time, 1},
                                     {"ms", HistoryKind::time, 1e-3},
                                     {"us", HistoryKind::time, 1e-6},
                                     {"min", HistoryKind::time, 60},
                                     {"h", HistoryKind::time, 3600},
                                     {"1/s", HistoryKind::rate, 1},
                                     {"1/min", HistoryKind::rate, 1.0 / 60},
                                     {"1/h", HistoryKind::rate, 1.0 / 3600}};

double unit_value(const std::string& text, HistoryKind kind, const Location& where) {
  const std::string unit = heading_of(text).unit;
  if (unit.empty()) return 1;
  std::vector<std::string> known;
  for (const KnownUnit& each : known_units) {
    if (each.kind == kind && unit == each.name) return each.factor;
    if (each.kind == kind) known.emplace_back(each.name);
  }
  constexpr const char* names[] = {"a stress", "a number", "a time", "a rate"};
  throw InputError(where, "",
                   "'" + unit + "' of the column '" + text + "' is no unit of " + names[static_cast<std::size_t>(kind)],
                   joined(known));
}

}  // namespace

void read_history_file(PathFunction& f, const std::string& name, const std::string& key, HistoryKind kind,
                       HistoryKind time_kind) {
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
  const double time_unit = unit_value(names[times], time_kind, head);
  const double value_unit = unit_value(names[values], kind, head);
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
    const double t = (*table.column(names[times]))[i] * time_unit;
    if (i == 0 && t < 0) refuse(i, "times must not be negative");
    if (i > 0 && t < f.times.back())
      refuse(i, "times must ascend, found " + number_text(t) + " s after " + number_text(f.times.back()) + " s");
    if (i > 1 && t == f.times[i - 2]) refuse(i, "three rows at one time");
    f.times.push_back(t);
    f.values.push_back((*table.column(names[values]))[i] * value_unit * f.factor + f.offset);
  }
  if (f.times.size() < 2) throw InputError({f.file, table.header_line, 1}, "", "a history needs two rows at least");
  if (f.times.front() == f.times.back()) refuse(f.times.size() - 1, "all rows are at one time");
}

}  // namespace assay::drivers
