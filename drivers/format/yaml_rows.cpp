// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_rows.hpp"

#include <cmath>

#include "drivers/format/yaml_writer.hpp"

namespace assay::drivers {

namespace {

/// "value: 1" of each row that has something to say.
std::vector<std::string> pairs_of(const YamlRows& rows) {
  std::vector<std::string> pairs;
  for (const YamlRow& row : rows) {
    const std::string text = row.said && !*row.said ? "" : row.written();
    if (!text.empty()) pairs.push_back(row.name + std::string(text.starts_with('\n') ? ":" : ": ") + text);
  }
  return pairs;
}

}  // namespace

YamlRow number_row(const char* name, double& value, const Range& range, bool* said) {
  return {name, [&value, range](const Tree& tree, const std::string& key) { value = number_value(tree, key, range); },
          [&value] { return std::isfinite(value) ? yaml_number(value) : std::string(); }, said};
}

YamlRow count_row(const char* name, int& value, int most, bool always) {
  const Range range{.lower = 1, .upper = static_cast<double>(most), .whole = true};
  return {name,
          [&value, range](const Tree& tree, const std::string& key) {
            value = static_cast<int>(number_value(tree, key, range));
          },
          [&value, always] { return value != 1 || always ? std::to_string(value) : std::string(); }};
}

YamlRow text_row(const char* name, std::string& value, bool always) {
  return {name, [&value](const Tree& tree, const std::string& key) { value = text_value(tree, key); },
          [&value, always] { return !value.empty() || always ? yaml_scalar(value) : std::string(); }};
}

void read_rows(const Tree& map, const std::string& path, const YamlRows& rows) {
  for (const YamlRow& row : rows) {
    const Tree* tree = map.find(row.name);
    if (row.said) *row.said = tree != nullptr;
    if (tree) row.read(*tree, key_path(path, row.name));
  }
}

void read_only_rows(const Tree& map, const std::string& path, const YamlRows& rows) {
  refuse_unknown_keys(map, path, names_of(rows));
  read_rows(map, path, rows);
}

std::vector<std::string> names_of(const YamlRows& rows) {
  std::vector<std::string> names;
  for (const YamlRow& row : rows) names.emplace_back(row.name);
  return names;
}

std::string flow_map(const YamlRows& rows) { return "{" + joined(pairs_of(rows)) + "}"; }

std::string flow_list(const std::vector<std::string>& values) { return "[" + joined(values) + "]"; }

std::string yaml_lines_of(const YamlRows& rows) {
  std::string text;
  for (const std::string& pair : pairs_of(rows)) text += pair + "\n";
  return text;
}

}  // namespace assay::drivers
