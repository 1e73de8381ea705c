// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_function.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

using Type = PathFunction::Type;

const std::vector<std::string> function_words{"constant", "ramp", "sine", "cycles", "table", "file"};
const std::vector<std::string> shape_words{"triangle", "sine"};
const std::vector<std::string> interpolation_words{"linear", "monotone", "spline"};

constexpr std::size_t most_values = 100'000;

std::vector<double> list_value(const Tree& tree, const std::string& key) {
  if (tree.kind != Tree::Kind::sequence) throw InputError(tree.where, key, "must be a list, found " + described(tree));
  std::vector<double> values;
  for (std::size_t i = 0; i < tree.items.size(); ++i) values.push_back(number_value(tree.items[i], item_path(key, i)));
  if (values.empty()) throw InputError(tree.where, key, "is empty");
  return values;
}

YamlRow list_row(const char* name, std::vector<double>& values) {
  return {name, [&values](const Tree& tree, const std::string& key) { values = list_value(tree, key); },
          [&values] {
            std::vector<std::string> texts;
            for (const double value : values) texts.push_back(yaml_number(value));
            return flow_list(texts);
          }};
}

YamlRow file_row(std::string& file) {
  YamlRow row = text_row("file", file, true);
  row.read = [&file](const Tree& tree, const std::string& key) {
    const auto folder = std::filesystem::path(tree.where.file).parent_path();
    file = absolute_path(folder / text_value(tree, key));
    if (const std::string fault = fault_of_file(file); !fault.empty()) throw InputError(tree.where, key, fault);
  };
  return row;
}

/// The keys that belong to a type, `type` first.
YamlRows rows_of(PathFunction& f) {
  YamlRows rows{word_row("type", f.type, function_words)};
  const auto add = [&](std::initializer_list<YamlRow> more) { rows.insert(rows.end(), more); };
  const YamlRow between = word_row("interpolation", f.interpolation, interpolation_words);
  const Range times{.lower = 0};
  if (f.type == Type::constant) add({number_row("value", f.value)});
  if (f.type == Type::ramp) {
    add({number_row("from", f.from, {}, &f.says_from), number_row("to", f.to), number_row("begin", f.begin, times),
         number_row("end", f.end, times)});
  }
  if (f.type == Type::sine) {
    add({number_row("amplitude", f.amplitude), number_row("period", f.period, positive), number_row("mean", f.mean),
         number_row("phase", f.phase)});
  }
  if (f.type == Type::cycles) {
    add({list_row("sizes", f.sizes), number_row("period", f.period, positive),
         word_row("shape", f.shape, shape_words)});
  }
  if (f.type == Type::table) add({list_row("times", f.times), list_row("values", f.values), between});
  if (f.type == Type::file) {
    add({file_row(f.file), text_row("column", f.column), text_row("time", f.time), between,
         number_row("factor", f.factor), number_row("offset", f.offset), text_row("unit", f.unit),
         text_row("time_unit", f.time_unit)});
  }
  return rows;
}

/// Of a type, those without which it says nothing.
std::vector<std::string> required_of(Type type) {
  if (type == Type::constant) return {"value"};
  if (type == Type::ramp) return {"to"};
  if (type == Type::sine) return {"amplitude", "period"};
  if (type == Type::cycles) return {"sizes", "period"};
  if (type == Type::table) return {"times", "values"};
  return {"file"};
}

void check_table(const Tree& tree, const std::string& key, const PathFunction& f) {
  if (f.times.size() != f.values.size()) {
    throw InputError(
        tree.where, key,
        "has " + std::to_string(f.times.size()) + " times for " + std::to_string(f.values.size()) + " values");
  }
  if (f.times.size() < 2) throw InputError(tree.where, key, "a table needs two times at least");
  if (f.times.size() > most_values)
    throw InputError(tree.where, key, "more than " + std::to_string(most_values) + " values");
  if (f.times.front() < 0) throw InputError(tree.where, key, "times must not be negative");
  for (std::size_t i = 1; i < f.times.size(); ++i) {
    if (f.times[i] < f.times[i - 1])
      throw InputError(tree.where, key,
                       "times must ascend, found " + number_text(f.times[i]) + " after " + number_text(f.times[i - 1]));
    if (i > 1 && f.times[i] == f.times[i - 2])
      throw InputError(tree.where, key, "three values at one time, " + number_text(f.times[i]));
  }
}

/// The numbers of the scene; those of a file are for its reader.
void convert_to_si(PathFunction& f, HistoryKind kind, const Units& units, const std::string& key) {
  const auto convert = [&](const Scale& scale, double& number) {
    number = scale.to_si(number);
    if (!std::isfinite(number)) throw InputError(f.where, key, "has a number without a value in SI units");
  };
  const Scale value = units.scale(si_unit_of(kind)), time = units.scale("s");
  for (double* each : {&f.value, &f.from, &f.to, &f.mean, &f.amplitude, &f.offset}) convert(value, *each);
  for (double* each : {&f.begin, &f.end, &f.period}) convert(time, *each);
  for (std::vector<double>* list : {&f.sizes, &f.values}) {
    for (double& each : *list) convert(value, each);
  }
  for (double& each : f.times) convert(time, each);
}

}  // namespace

double PathFunction::last() const {
  if (type == Type::table || type == Type::file) return times.empty() ? 0 : times.back();
  if (type == Type::cycles) return period * static_cast<double>(sizes.size());
  return type == Type::ramp ? end : 0;
}

PathFunction read_path_function(const Tree& tree, const std::string& key, const std::string& name, HistoryKind kind,
                                const Units& units) {
  PathFunction f;
  f.where = tree.where;
  if (tree.kind == Tree::Kind::scalar) {
    f.value = number_value(tree, key);
    convert_to_si(f, kind, units, key);
    return f;
  }
  require_map(tree, key, "a number, or a map with type: " + joined(function_words));
  const Tree* type = tree.find("type");
  if (!type) throw InputError(tree.where, key_path(key, "type"), "required and not given", joined(function_words));
  f.type = static_cast<Type>(
      index_of(choice_value(*type, key_path(key, "type"), function_words, "docs/paths.md"), function_words));
  for (const std::string& row : required_of(f.type)) {
    if (!tree.find(row)) throw InputError(tree.where, key_path(key, row), "required and not given");
  }
  read_only_rows(tree, key, rows_of(f));
  if (f.type == Type::table) check_table(tree, key, f);
  if (f.type == Type::ramp && f.end != 0 && f.end <= f.begin)
    throw InputError(tree.where, key_path(key, "end"), "must be behind begin");
  convert_to_si(f, kind, units, key);
  if (f.type == Type::file) read_history_file(f, name, key, kind, units);
  return f;
}

std::string path_function_yaml(const PathFunction& function) {
  if (function.type == Type::constant) return yaml_number(function.value);
  PathFunction copy = function;
  YamlRows rows = rows_of(copy);
  const auto is_si = [](const std::string& unit) { return unit.empty() || parse_unit(unit)->scale.is_one(); };
  std::erase_if(rows, [&](const YamlRow& row) {
    const std::string name = row.name;
    return (name == "from" && !function.says_from) || (name == "end" && function.end == 0) ||
           (name == "column" && function.column.empty()) || (name == "unit" && is_si(function.unit)) ||
           (name == "time_unit" && is_si(function.time_unit));
  });
  return flow_map(rows);
}

TimeFunction time_function_of(const PathFunction& f, double rest, double path_end) {
  if (f.type == Type::constant) return TimeFunction::constant(f.value);
  if (f.type == Type::ramp)
    return TimeFunction::ramp(f.says_from ? f.from : rest, f.to, f.begin, f.end > 0 ? f.end : path_end);
  if (f.type == Type::sine) return TimeFunction::sine(f.mean, f.amplitude, f.period, f.phase * std::numbers::pi / 180);
  if (f.type == Type::cycles) {
    return TimeFunction::cycles(f.sizes, f.period, f.shape == PathFunction::Shape::triangle).scaled(1, rest);
  }
  return TimeFunction::table(f.times, f.values, f.interpolation);
}

}  // namespace assay::drivers
