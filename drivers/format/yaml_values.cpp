// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/format/yaml_values.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

void refuse_value(const Tree& tree, const std::string& key, const std::string& what, const std::string& known) {
  throw InputError(tree.where, key, what, known);
}

std::string described(const Tree& tree) {
  switch (tree.kind) {
    case Tree::Kind::null:
      return "nothing";
    case Tree::Kind::sequence:
      return "a list";
    case Tree::Kind::map:
      return "a map";
    case Tree::Kind::scalar:
      break;
  }
  return "'" + shown(tree.text, 60) + "'";
}

std::string parent_of(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == path.npos ? std::string() : path.substr(0, dot);
}

std::string last_part(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string key_path(const std::string& prefix, const std::string& key) {
  return prefix.empty() ? key : prefix + "." + key;
}

std::string item_path(const std::string& list, std::size_t index) { return list + "[" + std::to_string(index) + "]"; }

double number_value(const Tree& tree, const std::string& key, const Range& range) {
  const bool plain = tree.kind == Tree::Kind::scalar && !tree.quoted;
  const std::string found = ", found " + described(tree);
  const std::optional<double> read = plain ? parse_number(tree.text) : std::nullopt;
  if (!read)
    refuse_value(tree, key,
                 std::string("must be a ") + (range.whole ? "whole number" : "number") + found + number_remedy(tree));
  const double value = read.value_or(0);
  if (!std::isfinite(value)) refuse_value(tree, key, "must be a finite number" + found);
  if (range.whole && value != std::floor(value)) refuse_value(tree, key, "must be a whole number" + found);
  constexpr double most = 9007199254740992.0;  // whole numbers beyond are not all there
  if (range.whole && std::abs(value) > most && range.holds(value))
    refuse_value(tree, key, "must be a whole number up to " + number_text(most) + found);
  if (!range.holds(value)) refuse_value(tree, key, "must be " + range.text() + found);
  return value;
}

bool boolean_value(const Tree& tree, const std::string& key) {
  const bool plain = tree.kind == Tree::Kind::scalar && !tree.quoted;
  if (plain && (tree.text == "true" || tree.text == "True" || tree.text == "TRUE")) return true;
  if (plain && (tree.text == "false" || tree.text == "False" || tree.text == "FALSE")) return false;
  refuse_value(tree, key, "must be true or false, found " + described(tree) + boolean_remedy(tree));
}

std::string text_value(const Tree& tree, const std::string& key) {
  if (tree.kind != Tree::Kind::scalar) refuse_value(tree, key, "must be text, found " + described(tree));
  return tree.text.substr(0, tree.text.find_last_not_of('\n') + 1);  // that of a block, as after `title: >`
}

std::string choice_value(const Tree& tree, const std::string& key, const std::vector<std::string>& known,
                         const std::string& source) {
  if (tree.kind != Tree::Kind::scalar)
    refuse_value(tree, key, "must be a word, found " + described(tree), joined(known));
  if (std::find(known.begin(), known.end(), tree.text) == known.end()) {
    refuse_value(tree, key, unknown("value " + described(tree), tree.text, known),
                 known_words(tree.text, known, source));
  }
  return tree.text;
}

std::vector<double> numbers_value(const Tree& tree, const std::string& key, std::size_t rows, std::size_t columns,
                                  const Range& range) {
  const std::size_t expected = rows == 1 ? columns : rows;
  const std::string shape = rows == 1 ? std::to_string(columns) + (range.whole ? " whole numbers" : " numbers")
                                      : std::to_string(rows) + " rows of " + std::to_string(columns) + " numbers";
  const std::string remedy = rows == 1 ? list_remedy(tree, columns) : "";
  if (tree.kind != Tree::Kind::sequence) {
    refuse_value(tree, key, "must be a list of " + shape + ", found " + described(tree) + remedy);
  }
  if (tree.items.size() != expected) {
    refuse_value(tree, key,
                 "must be a list of " + shape + ", found " + std::to_string(tree.items.size()) + " in it" + remedy);
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < expected; ++i) {
    const std::string item = item_path(key, i);
    if (rows == 1) {
      values.push_back(number_value(tree.items[i], item, range));
    } else {
      const std::vector<double> row = numbers_value(tree.items[i], item, 1, columns, range);
      values.insert(values.end(), row.begin(), row.end());
    }
  }
  return values;
}

void require_map(const Tree& tree, const std::string& key, const std::string& known) {
  if (tree.kind == Tree::Kind::map) return;
  const std::string remedy = tree.kind == Tree::Kind::scalar     ? key_remedy(tree.text)
                             : tree.kind == Tree::Kind::sequence ? ": its keys stand without '-' and brackets"
                                                                 : "";
  refuse_value(tree, key, "must be a map of keys, found " + described(tree) + remedy, known);
}

namespace {

/// Of a block that other places refer to.
std::string anchor_remedy(const Tree::Entry& entry, const std::string& prefix) {
  const bool capital = entry.key.starts_with("X-");
  if (!prefix.empty() || (!capital && !entry.value.anchored)) return {};
  return ": keys that hold anchors begin with x-, as x-" + shown(entry.key.substr(capital ? 2 : 0), 40);
}

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

void refuse_unknown_keys(const Tree& map, const std::string& prefix, const std::vector<std::string>& known) {
  for (const Tree::Entry& entry : map.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    throw InputError(entry.key_where, key_path(prefix, shown(entry.key, 80)),
                     unknown("key", entry.key, known) +
                         (parse_number(entry.key) ? ": numbers have a decimal point, and a comma ends a value" : "") +
                         key_remedy(entry.key) + anchor_remedy(entry, prefix),
                     known_words(entry.key, known));
  }
}

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
  return mapped(rows, [](const YamlRow& row) { return std::string(row.name); });
}

std::string flow_map(const YamlRows& rows) { return "{" + joined(pairs_of(rows)) + "}"; }

std::string flow_list(const std::vector<std::string>& values) { return "[" + joined(values) + "]"; }

std::string yaml_lines_of(const YamlRows& rows) {
  std::string text;
  for (const std::string& pair : pairs_of(rows)) text += pair + "\n";
  return text;
}

}  // namespace assay::drivers
