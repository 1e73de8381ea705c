// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/selection.hpp"

#include <algorithm>

#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

bool fulfils(const Condition& condition, const std::string* value) {
  using Kind = Condition::Kind;
  const auto listed = [&] {
    return value && std::any_of(condition.values.begin(), condition.values.end(),
                                [&](const std::string& each) { return same_value(each, *value); });
  };
  if (condition.kind == Kind::one_of) return listed();
  if (condition.kind == Kind::none_of) return !listed();
  const auto number = value ? parse_number(*value) : std::nullopt;
  if (!number) return false;
  if (condition.kind == Kind::below) return *number < condition.upper;
  if (condition.kind == Kind::above) return *number > condition.lower;
  return condition.lower <= *number && *number <= condition.upper;
}

std::vector<std::string> values_of(const Tree& tree, const std::string& path) {
  if (tree.kind != Tree::Kind::sequence) return {flow_text(tree)};
  if (tree.items.empty()) throw InputError(tree.where, path, "names no value");
  std::vector<std::string> values;
  for (const Tree& item : tree.items) values.push_back(flow_text(item));
  return values;
}

void read_operator(const Tree& map, const std::string& path, Condition& condition) {
  static const std::vector<std::string> known{"below", "above", "between", "not"};
  refuse_unknown_keys(map, path, known);
  if (map.entries.size() != 1) throw InputError(map.where, path, "must hold exactly one operator", joined(known));
  const auto& [name, where, value] = map.entries.front();
  const std::string inner = key_path(path, name);
  if (name == "not") {
    condition.kind = Condition::Kind::none_of;
    condition.values = values_of(value, inner);
  } else if (name == "between") {
    condition.kind = Condition::Kind::between;
    const std::vector<double> bounds = numbers_value(value, inner, 1, 2);
    condition.lower = bounds[0], condition.upper = bounds[1];
    if (!(condition.lower <= condition.upper))
      throw InputError(value.where, inner, "the first must not exceed the second");
  } else {
    condition.kind = name == "below" ? Condition::Kind::below : Condition::Kind::above;
    condition.lower = condition.upper = number_value(value, inner);
  }
}

}  // namespace

bool same_value(const std::string& a, const std::string& b) {
  const auto x = parse_number(a), y = parse_number(b);
  return a == b || (x && y && *x == *y);
}

std::string flow_text(const Tree& tree) {
  std::string text;
  switch (tree.kind) {
    case Tree::Kind::null:
      return "null";
    case Tree::Kind::scalar:
      return tree.text;
    case Tree::Kind::sequence:
      for (std::size_t i = 0; i < tree.items.size(); ++i) text += (i == 0 ? "" : ", ") + flow_text(tree.items[i]);
      return "[" + text + "]";
    case Tree::Kind::map:
      for (const Tree::Entry& entry : tree.entries) {
        text += (text.empty() ? "" : ", ") + yaml_scalar(entry.key) + ": " + flow_text(entry.value);
      }
      return "{" + text + "}";
  }
  return text;
}

bool Selection::holds(const std::vector<AxisValue>& values) const {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const AxisValue& each) { return each.axis == condition.axis; });
    return fulfils(condition, found == values.end() ? nullptr : &found->value);
  });
}

Selection read_selection(const Tree& map, const std::string& key) {
  require_map(map, key, "axes of the study");
  Selection selection{{}, map.where};
  for (const Tree::Entry& entry : map.entries) {
    Condition condition{entry.key, Condition::Kind::one_of, {}, 0, 0, entry.key_where};
    if (entry.value.kind == Tree::Kind::map) {
      read_operator(entry.value, key_path(key, entry.key), condition);
    } else {
      condition.values = values_of(entry.value, key_path(key, entry.key));
    }
    selection.conditions.push_back(std::move(condition));
  }
  return selection;
}

}  // namespace assay::drivers
