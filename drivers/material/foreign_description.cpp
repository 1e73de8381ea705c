// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/foreign_description.hpp"

#include <algorithm>
#include <optional>

#include "drivers/format/yaml_values.hpp"
#include "drivers/material/foreign_properties.hpp"
#include "drivers/material/foreign_words.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using namespace foreign_words;

namespace {

using adapters::Axes;
using adapters::ForeignInterface;
using adapters::ForeignModel;
using adapters::ForeignVariable;
using adapters::Kinematics;
using Kind = ForeignVariable::Kind;

std::size_t index_of(const std::string& word, const std::vector<std::string>& known) {
  return static_cast<std::size_t>(std::find(known.begin(), known.end(), word) - known.begin());
}

class Reader {
 public:
  Reader(const Tree& root, ForeignModel& model, std::map<std::string, Location>& where)
      : root_(root), model_(model), where_(where) {}

  void read() {
    if (const Tree* tree = root_.find("symbol")) model_.symbol = text_value(*tree, "symbol");
    if (const Tree* tree = root_.find("properties")) read_properties(*tree, model_, where_);
    if (const Tree* tree = root_.find("state")) read_state(*tree);
    if (const Tree* tree = root_.find("kinematics")) {
      const bool abaqus = choice_value(*tree, "kinematics", {"objective", "abaqus"}) == "abaqus";
      model_.kinematics = abaqus ? Kinematics::abaqus : Kinematics::objective;
    }
    if (const Tree* tree = root_.find("axes")) read_axes(*tree);
    if (const Tree* tree = root_.find("fields")) read_fields(*tree);
    if (const Tree* tree = root_.find("step")) {
      model_.step =
          static_cast<int>(number_value(*tree, "step", {.lower = 1, .upper = most_components, .whole = true}));
    }
    read_elements();
    model_.strain_is_said = root_.find("strain") != nullptr;
    if (const Tree* tree = root_.find("strain")) {
      model_.finite_strain = choice_value(*tree, "strain", {"small", "finite"}) == "finite";
    }
    model_.symmetry_is_said = root_.find("symmetry") != nullptr;
    if (const Tree* tree = root_.find("symmetry")) read_symmetry(*tree);
    model_.flags_are_said = root_.find("flags") != nullptr;
    if (const Tree* tree = root_.find("flags")) read_flags(*tree);
    model_.components_are_said = root_.find("components") != nullptr;
    if (const Tree* tree = root_.find("components")) read_components(*tree);
    if (const Tree* tree = root_.find("units")) read_units(*tree);
    if (const Tree* tree = root_.find("temperature")) {
      model_.temperature = number_value(*tree, "temperature");
      model_.temperature_is_said = true;
    }
    if (const Tree* tree = root_.find("characteristic_length")) {
      model_.characteristic_length = number_value(*tree, "characteristic_length", {.lower = 0, .lower_open = true});
    }
    if (const Tree* tree = root_.find("density")) {
      model_.density = number_value(*tree, "density", {.lower = 0, .lower_open = true});
    }
    if (const Tree* tree = root_.find("material_name")) {
      constexpr std::size_t longest = 80;  // CMNAME
      model_.material_name = text_value(*tree, "material_name");
      if (model_.material_name.size() > longest)
        throw InputError(tree->where, "material_name", "has more than 80 letters");
    }
    for (const Tree::Entry& entry : root_.entries) where_[entry.key] = entry.value.where;
  }

 private:
  void read_state(const Tree& tree) {
    if (number_in(tree)) {  // so many scalars
      const double count = number_value(tree, "state", {.lower = 0, .upper = most_components, .whole = true});
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) add_unknown(numbered("s", k));
      return;
    }
    if (tree.kind == Tree::Kind::sequence) {
      for (const Tree& item : tree.items) {
        const std::string name = text_value(item, "state");
        const auto same = [&](const ForeignVariable& other) { return other.name == name; };
        if (std::any_of(model_.state.begin(), model_.state.end(), same))
          throw InputError(item.where, "state." + one_line(name, 80), "is there twice");
        add_unknown(name);
      }
      return;
    }
    require_map(tree, "state", "the state variables of the model, in its order: names and kinds");
    for (const Tree::Entry& entry : tree.entries) read_variable(entry);
  }

  void add_unknown(const std::string& name) {
    model_.state.push_back({name});
    model_.state.back().kind_is_said = false;
  }

  void read_variable(const Tree::Entry& entry) {
    const std::string key = "state." + one_line(entry.key, 80);
    where_["state." + entry.key] = entry.value.where;
    if (number_in(entry.value)) refuse_bare_number(entry.value, key);
    ForeignVariable variable{entry.key};
    std::size_t count = 1;
    if (entry.value.kind == Tree::Kind::map) {
      refuse_unknown_keys(entry.value, key, {"kind", "count", "initial", "unit", "doc"});
      variable.kind_is_said = entry.value.find("kind") != nullptr;
      if (const Tree* at = entry.value.find("kind")) variable.kind = kind_value(*at, key + ".kind");
      if (const Tree* at = entry.value.find("count")) {
        count = static_cast<std::size_t>(
            number_value(*at, key + ".count", {.lower = 1, .upper = most_components, .whole = true}));
      }
      if (const Tree* at = entry.value.find("initial")) variable.initial = initial_value(*at, key, variable.kind);
      if (const Tree* at = entry.value.find("unit")) variable.unit = text_value(*at, key + ".unit");
      if (const Tree* at = entry.value.find("doc")) variable.doc = text_value(*at, key + ".doc");
    } else {
      variable.kind = kind_value(entry.value, key);
    }
    for (std::size_t k = 0; k < count; ++k) {
      model_.state.push_back(variable);
      if (count > 1) model_.state.back().name = entry.key + "[" + std::to_string(k + 1) + "]";
    }
  }

  /// `state: 14` is a count, and so could this be.
  static void refuse_bare_number(const Tree& tree, const std::string& key) {
    const std::string text = one_line(tree.text, 40);
    const bool counts = parse_integer(tree.text).value_or(0) > 0;
    throw InputError(tree.where, key,
                     counts ? "a number alone may be a count or a first value: write {count: " + text +
                                  "} or {initial: " + text + "}"
                            : "a number alone is no kind: a first value is {initial: " + text + "}");
  }

  static Kind kind_value(const Tree& tree, const std::string& key) {
    return static_cast<Kind>(index_of(choice_value(tree, key, kinds), kinds));
  }

  std::vector<double> initial_value(const Tree& tree, const std::string& key, Kind kind) const {
    if (tree.kind != Tree::Kind::sequence) return {number_value(tree, key + ".initial")};
    constexpr std::size_t sizes[] = {1, 3, 6, 6, 9, 6};
    const bool library_knows = model_.interface == ForeignInterface::mfront;
    const std::size_t size =
        library_knows ? std::max<std::size_t>(tree.items.size(), 1) : sizes[static_cast<std::size_t>(kind)];
    return numbers_value(tree, key + ".initial", 1, size);
  }

  int counted(const char* key, int otherwise) const {
    const Tree* tree = root_.find(key);
    if (!tree) return otherwise;
    return static_cast<int>(number_value(*tree, key, {.lower = 1, .upper = most_elements, .whole = true}));
  }

  void read_elements() {
    model_.element = counted("noel", 1);
    model_.point = counted("npt", 1);
    const Tree* tree = root_.find("elements");
    if (!tree) return;
    model_.each_its_element = choice_value(*tree, "elements", elements_words) == "each";
    if (!model_.each_its_element) return;
    if (model_.interface != ForeignInterface::umat) {
      throw InputError(tree->where, "elements", "each is for UMATs alone: no other interface counts elements");
    }
    if (root_.find("noel")) throw InputError(root_.find("noel")->where, "noel", "contradicts elements: each");
  }

  void read_symmetry(const Tree& tree) {
    const int index = static_cast<int>(index_of(choice_value(tree, "symmetry", symmetries), symmetries));
    model_.symmetry = std::min(index, static_cast<int>(ASSAY_ANISOTROPIC));
    model_.material_class = index - model_.symmetry;
  }

  void read_axes(const Tree& tree) {
    model_.axes = static_cast<Axes>(index_of(choice_value(tree, "axes", axes_words), axes_words));
    if (model_.axes != Axes::fixed && model_.interface != ForeignInterface::umat) {
      throw InputError(tree.where, "axes", "is for UMATs alone: the axes of other interfaces are theirs");
    }
  }

  void read_fields(const Tree& tree) {
    require_map(tree, "fields", "the fields of the host, in the model's order: names and values");
    for (const Tree::Entry& entry : tree.entries) {
      where_["fields." + entry.key] = entry.value.where;
      model_.fields.push_back({entry.key, number_value(entry.value, "fields." + one_line(entry.key, 80))});
    }
  }

  void read_flags(const Tree& tree) {
    if (tree.kind != Tree::Kind::sequence) {
      throw InputError(tree.where, "flags", "must be a list, found " + described(tree), joined(flag_words));
    }
    for (const Tree& item : tree.items) {
      model_.flags |= flag_bits[index_of(choice_value(item, "flags", flag_words), flag_words)];
    }
  }

  void read_components(const Tree& tree) {
    const std::vector<Tree> one{tree};
    model_.components.clear();
    for (const Tree& item : tree.kind == Tree::Kind::sequence ? tree.items : one) {
      model_.components.push_back(std::stoi(choice_value(item, "components", {"4", "6"})));
    }
    if (model_.components.empty()) throw InputError(tree.where, "components", "must name 6, 4 or both");
  }

  void read_units(const Tree& tree) {
    require_map(tree, "units", "stress, time, length");
    refuse_unknown_keys(tree, "units", {"stress", "time", "length"});
    const auto unit = [&](const char* key, const Units& known, double& out) {
      const Tree* at = tree.find(key);
      if (!at) return;
      std::vector<std::string> words;
      for (const auto& [word, value] : known) words.push_back(word);
      out = known[index_of(choice_value(*at, std::string("units.") + key, words), words)].second;
    };
    unit("stress", stress_units, model_.units.stress);
    unit("time", time_units, model_.units.time);
    unit("length", length_units, model_.units.length);
  }

  const Tree& root_;
  ForeignModel& model_;
  std::map<std::string, Location>& where_;
};

}  // namespace

ForeignModel read_foreign(const Tree& root, const std::string& interface, const std::string& library,
                          const std::string& name, std::map<std::string, Location>& where) {
  ForeignModel model;
  model.interface = static_cast<ForeignInterface>(index_of(interface, interface_names()) - 1);
  model.library = library;
  model.name = name;
  model.doc = interface;
  if (model.interface == ForeignInterface::umat) model.symbol = "umat_";
  if (model.interface == ForeignInterface::vumat) model.symbol = "vumat_";
  if (model.interface == ForeignInterface::mfront) model.temperature = room_temperature;
  Reader(root, model, where).read();
  return model;
}

}  // namespace assay::drivers
