// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/key_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"

namespace assay::drivers {

namespace {

/// Where a key belongs that this section has not; empty where nothing is known.
std::string place_of(const Tree::Entry& entry, const std::string& section, const std::vector<std::string>& here) {
  const std::vector<std::string> top = names_under("");
  if (!section.empty() && is_one_of(entry.key, top))
    return "unknown key here: it belongs to the scene itself, beside " + section.substr(0, section.find('.'));
  const bool common = is_one_of(entry.key, {"type", "final", "path"});
  for (const Key& key : scene_keys()) {
    if (common || last_part(key.path) != entry.key) continue;
    return "unknown key here: it belongs to " + parent_of(key.path);
  }
  for (const Key& key : scene_keys()) {
    if (is_one_of(entry.key, item_names(key))) return "unknown key here: it belongs to an item of " + key.path;
  }
  const bool number = entry.value.kind == Tree::Kind::scalar && parse_number(entry.value.text);
  const bool parameter = section == "material" && number && nearest(entry.key, here).empty();
  return parameter ? "unknown key: parameters of the model belong to material.parameters" : "";
}

KeyRecord read_item(const Key& list, const Tree& tree, const std::string& path, const Units& units) {
  require_map(tree, path, joined(item_names(list)));
  refuse_other_keys(tree, path, item_names(list));
  KeyRecord item;
  for (Key key : list.items) {
    const std::string name = key.path;
    key.path = key_path(path, name);
    const Tree* value = tree.find(name);
    if (value)
      item.values.emplace_back(name, read_value(key, *value, units, key.unit));
    else if (key.required)
      throw InputError(tree.where, key.path, "required and not given");
  }
  return item;
}

std::vector<KeyRecord> read_items(const Key& list, const Tree& tree, const Units& units) {
  const bool is_list = tree.kind == Tree::Kind::sequence;
  if (!is_list || tree.items.empty()) {
    const std::string remedy = tree.kind == Tree::Kind::map ? ": each item begins with '-'" : "";
    refuse_value(tree, list.path,
                 "must be a list of maps, found " + (is_list ? "an empty list" : described(tree)) + remedy,
                 joined(item_names(list)));
  }
  std::vector<KeyRecord> items;
  for (const Tree& item : tree.items) items.push_back(read_item(list, item, item_path(list.path, items.size()), units));
  return items;
}

/// A whole number has no exponent: readers take it for one.
std::string number_of(const Key& key, double value) {
  return key.range.whole ? std::to_string(static_cast<std::int64_t>(value)) : yaml_number(value);
}

std::string list_text(const Key& key, std::span<const double> values) {
  return flow_list(mapped(values, [&](double value) { return number_of(key, value); }));
}

/// "{profile: ball, radius: 0.4}", without the keys that are absent.
std::string item_text(const Key& list, const KeyRecord& item) {
  std::vector<std::string> pairs;
  for (const Key& key : list.items) {
    if (const Value* value = item.find(key.path)) pairs.push_back(key.path + ": " + value_text(key, *value));
  }
  return "{" + joined(pairs) + "}";
}

}  // namespace

void refuse_other_keys(const Tree& map, const std::string& path, const std::vector<std::string>& known) {
  for (const Tree::Entry& entry : map.entries) {
    if (is_one_of(entry.key, known)) continue;
    const std::string what = place_of(entry, path, known);
    if (!what.empty()) throw InputError(entry.key_where, key_path(path, shown(entry.key, 80)), what, joined(known));
  }
  refuse_unknown_keys(map, path, known);
}

namespace {

Value read_plain(const Key& key, const Tree& tree) {
  switch (key.type) {
    case KeyType::number:
      return number_value(tree, key.path, key.range);
    case KeyType::automatic:
      if (tree.kind == Tree::Kind::scalar && tree.text == "auto") return tree.text;
      if (tree.kind == Tree::Kind::scalar && !parse_number(tree.text)) {
        throw InputError(tree.where, key.path,
                         "must be a number or auto, found " + described(tree) + number_remedy(tree));
      }
      return number_value(tree, key.path, key.range);
    case KeyType::boolean:
      return boolean_value(tree, key.path);
    case KeyType::text:
      return text_value(tree, key.path);
    case KeyType::choice:
      return choice_value(tree, key.path, key.choices);
    case KeyType::pair:
      return numbers_value(tree, key.path, 1, 2, key.range);
    case KeyType::vector:
      return numbers_value(tree, key.path, 1, 3, key.range);
    case KeyType::six:
      return numbers_value(tree, key.path, 1, 6, key.range);
    case KeyType::pair_or_vector:
    case KeyType::per_axis:
      return numbers_value(tree, key.path, 1, tree.items.size() == 3 ? 3 : 2, key.range);
    case KeyType::matrix:
      return numbers_value(tree, key.path, 3, 3, key.range);
    case KeyType::list:
      break;
  }
  return {};
}

}  // namespace

Value in_si(const Key& key, Value value, const Scale& scale, const Tree& tree) {
  const auto convert = [&](double& number) {
    const bool was_zero = number == 0;
    number = scale.to_si(number);
    if (!std::isfinite(number) || (number == 0 && !was_zero))
      refuse_value(tree, key.path, "has no value in SI units, found " + described(tree));
  };
  if (auto* number = std::get_if<double>(&value)) convert(*number);
  if (auto* list = std::get_if<std::vector<double>>(&value)) std::ranges::for_each(*list, convert);
  return value;
}

Value read_value(const Key& key, const Tree& tree, const Units& units, const std::string& unit) {
  if (key.type == KeyType::list) return read_items(key, tree, units);
  const Scale scale = units.scale(unit);
  Key own = key;
  own.range = in_units(key.range, scale);
  return in_si(key, read_plain(own, tree), scale, tree);
}

std::map<std::string, Location> places_of_value(const Key& key, const Tree& tree) {
  std::map<std::string, Location> places{{key.path, tree.where}};
  if (key.type != KeyType::list) return places;
  for (std::size_t k = 0; k < tree.items.size(); ++k) {
    const std::string path = item_path(key.path, k);
    places[path] = tree.items[k].where;
    for (const Tree::Entry& entry : tree.items[k].entries) places[key_path(path, entry.key)] = entry.value.where;
  }
  return places;
}

std::string value_text(const Key& key, const Value& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value)) return number_of(key, *number);
  if (const auto* text = std::get_if<std::string>(&value)) return yaml_scalar(*text);
  if (const auto* items = std::get_if<std::vector<KeyRecord>>(&value)) {
    std::string lines;
    for (const KeyRecord& item : *items) lines += "\n" + indent_of_key(key.path + ".") + "- " + item_text(key, item);
    return lines;
  }
  const std::span<const double> list = std::get<std::vector<double>>(value);
  if (key.type != KeyType::matrix) return list_text(key, list);
  return flow_list(
      {list_text(key, list.subspan(0, 3)), list_text(key, list.subspan(3, 3)), list_text(key, list.subspan(6, 3))});
}

std::string indent_of_key(const std::string& path) {
  return std::string(2 * static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')), ' ');
}

}  // namespace assay::drivers
