// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/foreign_properties.hpp"

#include <cmath>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_slips.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using adapters::ForeignModel;
using adapters::ForeignProperty;

std::optional<double> number_in(const Tree& tree) {
  if (tree.kind != Tree::Kind::scalar || tree.quoted) return std::nullopt;
  return parse_number(tree.text);
}

std::string numbered(const std::string& stem, std::size_t k) { return stem + std::to_string(k + 1); }

namespace {

class PropertyReader {
 public:
  PropertyReader(ForeignModel& model, std::map<std::string, Location>& where) : model_(model), where_(where) {}

  void read(const Tree& tree) {
    if (tree.kind == Tree::Kind::sequence) {
      for (std::size_t k = 0; k < tree.items.size(); ++k) {
        const Tree& item = tree.items[k];
        const std::string key = "properties." + numbered("p", k);
        if (number_in(item)) {
          add_property(numbered("p", k), number_value(item, key), item.where);
        } else {
          refuse_no_name(item, key);
          add_property(text_value(item, key), NAN, item.where);
        }
      }
      return;
    }
    if (const std::string list = list_remedy(tree, 0); !list.empty())
      throw InputError(tree.where, "properties", "must be a list or a map, found " + described(tree) + list);
    require_map(tree, "properties", "the properties of the model, in its order: names and values");
    for (const Tree::Entry& entry : tree.entries) {
      const std::string key = "properties." + one_line(entry.key, 80);
      const Tree& value = entry.value;
      if (value.kind == Tree::Kind::null && entry.key.find('=') != entry.key.npos)
        throw InputError(entry.key_where, key, "is no name" + key_remedy(entry.key));
      if (value.kind != Tree::Kind::map) {
        add_property(entry.key, value.kind == Tree::Kind::null ? NAN : number_value(value, key), value.where);
        continue;
      }
      refuse_unknown_keys(value, key, {"value", "unit", "lower", "upper", "doc"});
      ForeignProperty& p = add_property(entry.key, NAN, value.where);
      if (const Tree* at = value.find("value")) p.value = number_value(*at, key + ".value");
      if (const Tree* at = value.find("lower")) p.lower = number_value(*at, key + ".lower");
      if (const Tree* at = value.find("upper")) p.upper = number_value(*at, key + ".upper");
      if (const Tree* at = value.find("unit")) p.unit = text_value(*at, key + ".unit");
      if (const Tree* at = value.find("doc")) p.doc = text_value(*at, key + ".doc");
      require_within(p, key, value.where);
    }
  }

 private:
  /// A number that is written otherwise is no name, nor is "E=1000", or a map behind a hyphen.
  static void refuse_no_name(const Tree& item, const std::string& key) {
    const std::string what = "must be a number or a name";
    if (item.kind == Tree::Kind::map) throw InputError(item.where, key, what + ": keys with values stand without '-'");
    if (item.kind != Tree::Kind::scalar) return;
    const bool begins_as_number = !item.quoted && item.text.find_first_of("0123456789.+-") == 0;
    if (item.text.find('=') != item.text.npos)
      throw InputError(item.where, key,
                       what + ", found " + described(item) + ": names with values are a map, {E: 1000}");
    if (begins_as_number) throw InputError(item.where, key, what + ", found " + described(item) + number_remedy(item));
  }

  static void require_within(const ForeignProperty& p, const std::string& key, const Location& place) {
    if (p.lower > p.upper) throw InputError(place, key, "has bounds that leave nothing: lower is above upper");
    if (p.value < p.lower || p.value > p.upper) throw InputError(place, key, "has a value outside of its own bounds");
  }

  ForeignProperty& add_property(const std::string& name, double value, const Location& place) {
    for (const ForeignProperty& other : model_.properties) {
      if (other.name == name) throw InputError(place, "properties." + one_line(name, 80), "is there twice");
    }
    if (name.empty()) throw InputError(place, "properties", "a property needs a name");
    where_["properties." + name] = place;
    model_.properties.push_back({name, "", "", value});
    return model_.properties.back();
  }

  ForeignModel& model_;
  std::map<std::string, Location>& where_;
};

}  // namespace

void read_properties(const Tree& tree, ForeignModel& model, std::map<std::string, Location>& where) {
  PropertyReader(model, where).read(tree);
}

}  // namespace assay::drivers
