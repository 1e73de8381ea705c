// SPDX-License-Identifier: BSD-3-Clause
// The lists in a foreign model's description: parameters and state variables.
#include "drivers/material/foreign_description.hpp"

#include <cmath>
#include <optional>

#include "adapters/foreign/foreign_state.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using adapters::ForeignModel;
using adapters::ForeignProperty;
using adapters::ForeignVariable;

namespace {

/// A scalar that reads as a number.
std::optional<double> number_in(const Tree& tree) {
  return tree.kind == Tree::Kind::scalar && !tree.quoted ? parse_number(tree.text) : std::nullopt;
}

template <class T>
void refuse_twice(const std::vector<T>& list, const std::string& name, const std::string& key, const Tree& tree) {
  if (adapters::has_name(list, name)) refuse_value(tree, key + "." + one_line(name, 80), "is there twice");
}

/// A block of lines, "  name: {...}" of each.
template <class T, class Rows>
std::string block_of(std::vector<T>& list, const Rows& rows) {
  std::string text;
  for (T& each : list) text += "\n  " + yaml_scalar(each.name) + ": " + flow_map(rows(each));
  return text;
}

YamlRows rows_of(ForeignProperty& p) {
  return {number_row("value", p.value), text_row("unit", p.unit), number_row("lower", p.lower),
          number_row("upper", p.upper), text_row("doc", p.doc)};
}

ForeignProperty& add_property(const std::string& name, double value, const Tree& tree, ForeignModel& model,
                              Places& where) {
  refuse_twice(model.properties, name, "properties", tree);
  if (name.empty()) refuse_value(tree, "properties", "a property needs a name");
  where["properties." + name] = tree.where;
  model.properties.push_back({name, "", "", value});
  return model.properties.back();
}

/// A number that is written otherwise is no name, nor is "E=1000", or a map behind a hyphen.
void read_listed_property(const Tree& item, const std::string& name, ForeignModel& model, Places& where) {
  const std::string key = "properties." + name, what = "must be a number or a name";
  const bool is_scalar = item.kind == Tree::Kind::scalar;
  if (number_in(item)) {
    add_property(name, number_value(item, key), item, model, where);
    return;
  }
  if (item.kind == Tree::Kind::map) refuse_value(item, key, what + ": keys with values stand without '-'");
  if (is_scalar && item.text.find('=') != item.text.npos)
    refuse_value(item, key, what + ", found " + described(item) + ": names with values are a map, {E: 1000}");
  if (is_scalar && !item.quoted && item.text.find_first_of("0123456789.+-") == 0)
    refuse_value(item, key, what + ", found " + described(item) + number_remedy(item));
  add_property(text_value(item, key), NAN, item, model, where);
}

void read_properties(const Tree& tree, ForeignModel& model, Places& where) {
  for (std::size_t k = 0; k < tree.items.size(); ++k)
    read_listed_property(tree.items[k], "p" + std::to_string(k + 1), model, where);
  if (tree.kind == Tree::Kind::sequence) return;
  if (const std::string list = list_remedy(tree, 0); !list.empty())
    refuse_value(tree, "properties", "must be a list or a map, found " + described(tree) + list);
  require_map(tree, "properties", "the properties of the model, in its order: names and values");
  for (const auto& [name, name_where, value] : tree.entries) {
    const std::string key = "properties." + one_line(name, 80);
    const bool is_null = value.kind == Tree::Kind::null, is_map = value.kind == Tree::Kind::map;
    if (is_null && name.find('=') != name.npos) throw InputError(name_where, key, "is no name" + key_remedy(name));
    ForeignProperty& p = add_property(name, is_null || is_map ? NAN : number_value(value, key), value, model, where);
    if (is_map) read_only_rows(value, key, rows_of(p));
    if (p.lower > p.upper) refuse_value(value, key, "has bounds that leave nothing: lower is above upper");
    if (p.value < p.lower || p.value > p.upper) refuse_value(value, key, "has a value outside of its own bounds");
  }
}

const std::vector<std::string> kinds = words_of<ForeignVariable::Kind>();

/// One value, or one for each component; the library of an MFront behaviour knows how many.
YamlRow initial_row(ForeignVariable& v, bool any_size) {
  const auto read = [&v, any_size](const Tree& tree, const std::string& key) {
    if (tree.kind != Tree::Kind::sequence) return v.initial.assign(1, number_value(tree, key));
    const std::size_t size = any_size ? std::max<std::size_t>(tree.items.size(), 1)
                                      : static_cast<std::size_t>(adapters::components_of(v.kind));
    v.initial = numbers_value(tree, key, 1, size);
  };
  const auto written = [&v] {
    const std::vector<std::string> numbers = mapped(v.initial, yaml_number);
    return numbers.empty() ? "" : numbers.size() == 1 ? numbers.front() : flow_list(numbers);
  };
  return {"initial", read, written};
}

/// count: of variables that are alike.
YamlRows rows_of(ForeignVariable& v, int& count, bool any_size) {
  return {word_row("kind", v.kind, kinds, &v.kind_is_said), count_row("count", count, most_foreign_components),
          initial_row(v, any_size), text_row("unit", v.unit), text_row("doc", v.doc)};
}

void read_variable(const Tree::Entry& entry, ForeignModel& model, Places& where) {
  const Tree& value = entry.value;
  const std::string key = "state." + one_line(entry.key, 80);
  where["state." + entry.key] = value.where;
  if (number_in(value)) {  // `state: 14` is a count, and so could this be
    const std::string text = one_line(value.text, 40), first = "{initial: " + text + "}";
    refuse_value(value, key,
                 parse_integer(value.text).value_or(0) > 0
                     ? "a number alone may be a count or a first value: write {count: " + text + "} or " + first
                     : "a number alone is no kind: a first value is " + first);
  }
  ForeignVariable variable{entry.key};
  int count = 1;
  if (value.kind == Tree::Kind::map)
    read_only_rows(value, key, rows_of(variable, count, model.interface == adapters::ForeignInterface::mfront));
  else
    word_row("", variable.kind, kinds).read(value, key);
  for (int k = 1; k <= count; ++k) {
    model.state.push_back(variable);
    if (count > 1) model.state.back().name = entry.key + "[" + std::to_string(k) + "]";
  }
}

void read_state(const Tree& tree, ForeignModel& model, Places& where) {
  const auto add_unknown = [&](const std::string& name) {
    model.state.push_back({name});
    model.state.back().kind_is_said = false;
  };
  if (number_in(tree)) {  // so many scalars
    const double count = number_value(tree, "state", {.lower = 0, .upper = most_foreign_components, .whole = true});
    for (int k = 1; k <= static_cast<int>(count); ++k) add_unknown("s" + std::to_string(k));
  } else if (tree.kind == Tree::Kind::sequence) {
    for (const Tree& item : tree.items) {
      refuse_twice(model.state, text_value(item, "state"), "state", item);
      add_unknown(text_value(item, "state"));
    }
  } else {
    require_map(tree, "state", "the state variables of the model, in its order: names and kinds");
    for (const Tree::Entry& entry : tree.entries) read_variable(entry, model, where);
  }
}

}  // namespace

YamlRow properties_row(ForeignModel& model, Places& where) {
  return {"properties", [&](const Tree& tree, const std::string&) { read_properties(tree, model, where); },
          [&] { return block_of(model.properties, [](ForeignProperty& p) { return rows_of(p); }); }};
}

YamlRow state_row(ForeignModel& model, Places& where) {
  static int one = 1;
  return {"state", [&](const Tree& tree, const std::string&) { read_state(tree, model, where); },
          [&] { return block_of(model.state, [](ForeignVariable& v) { return rows_of(v, one, true); }); }};
}

}  // namespace assay::drivers
