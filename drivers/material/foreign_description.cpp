// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/foreign_description.hpp"

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "drivers/format/unit_rows.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using adapters::ForeignInterface;
using adapters::ForeignModel;

namespace {

constexpr int most_elements = 2000000000;    ///< of a Fortran integer
constexpr double room_temperature = 293.15;  ///< [K]

/// Those of assay_material, then the classes of assay_symmetry.
const std::vector<std::string> symmetries{
    "isotropic", "cylindrically_orthotropic", "anisotropic", "monoclinic", "orthotropic", "trigonal", "tetragonal",
    "hexagonal", "transversely_isotropic",    "cubic"};
const std::vector<std::string> flag_words{"non_smooth", "rate_dependent", "thread_safe", "grows"};
constexpr std::uint32_t flag_bits[] = {ASSAY_NON_SMOOTH, ASSAY_RATE_DEPENDENT, ASSAY_THREAD_SAFE, ASSAY_GROWS};

YamlRows rows_of(adapters::ModelUnits& units) {
  return {unit_row("stress", units.stress, unit_words("Pa")), unit_row("time", units.time, unit_words("s")),
          unit_row("length", units.length, unit_words("m"))};
}

void read_host_fields(const Tree& tree, ForeignModel& model, Places& where) {
  require_map(tree, "fields", "the fields of the host, in the model's order: names and values");
  for (const Tree::Entry& entry : tree.entries) {
    where["fields." + entry.key] = entry.value.where;
    if (model.interface != ForeignInterface::mfront && entry.key == adapters::temperature_field)
      refuse_value(entry.value, "fields." + entry.key, "is no field here: the key `temperature` says it");
    model.fields.push_back({entry.key, number_value(entry.value, "fields." + one_line(entry.key, 80))});
  }
}

std::string host_fields_text(const ForeignModel& model) {
  const auto pair = [](const auto& field) { return yaml_scalar(field.name) + ": " + yaml_number(field.value); };
  return model.fields.empty() ? "" : "{" + joined(model.fields, pair) + "}";
}

/// Of MFront.
YamlRow hypothesis_row(ForeignModel& m) {
  const auto read = [&m](const Tree& tree, const std::string& key) {
    m.hypothesis = choice_value(tree, key, adapters::mfront_hypotheses(), "docs/foreign.md");
  };
  const std::string usual = ForeignModel{}.hypothesis;
  return {"hypothesis", read, [&m, usual] { return m.hypothesis == usual ? "" : m.hypothesis; }};
}

/// Names of fields that a path may change.
YamlRow varying_row(ForeignModel& m, Places& where) {
  const auto read = [&m, &where](const Tree& tree, const std::string& key) {
    for (const Tree& item : tree.kind == Tree::Kind::sequence ? tree.items : std::vector<Tree>{tree}) {
      const std::string name = text_value(item, key);
      if (is_one_of(name, m.varying)) refuse_value(item, key, "names '" + one_line(name, 80) + "' twice");
      where[key_path(key, name)] = item.where;
      m.varying.push_back(name);
    }
  };
  return {"varying", read, [&m] { return m.varying.empty() ? "" : flow_list(mapped(m.varying, yaml_scalar)); }};
}

YamlRow symmetry_row(ForeignModel& m) {
  const auto read = [&m](const Tree& tree, const std::string& key) {
    int word = 0;
    word_row("", word, symmetries).read(tree, key);
    m.symmetry = std::min(word, static_cast<int>(ASSAY_ANISOTROPIC));
    m.material_class = word - m.symmetry;
  };
  const auto written = [&m] { return symmetries[static_cast<std::size_t>(m.symmetry + m.material_class)]; };
  return {"symmetry", read, written, &m.symmetry_is_said};
}

YamlRow flags_row(ForeignModel& m) {
  const auto read = [&m](const Tree& tree, const std::string& key) {
    if (tree.kind != Tree::Kind::sequence)
      refuse_value(tree, key, "must be a list, found " + described(tree), joined(flag_words));
    for (const Tree& item : tree.items) m.flags |= flag_bits[index_of(choice_value(item, key, flag_words), flag_words)];
  };
  const auto written = [&m] {
    std::vector<std::string> words;
    for (std::size_t k = 0; k < std::size(flag_bits); ++k) {
      if (m.flags & flag_bits[k]) words.push_back(flag_words[k]);
    }
    return flow_list(words);
  };
  return {"flags", read, written, &m.flags_are_said};
}

YamlRow components_row(ForeignModel& m) {
  const auto read = [&m](const Tree& tree, const std::string& key) {
    m.components.clear();
    for (const Tree& item : tree.kind == Tree::Kind::sequence ? tree.items : std::vector<Tree>{tree})
      m.components.push_back(std::stoi(choice_value(item, key, {"3", "4", "6"})));
    if (m.components.empty()) refuse_value(tree, key, "must name 6, 4 or both, or 3");
    if (m.components.size() > 1 && std::ranges::count(m.components, 3) > 0)
      refuse_value(tree, key, "3 stands alone: plane stress needs a description of its own");
  };
  const auto written = [&m] { return flow_list(mapped(m.components, [](int n) { return std::to_string(n); })); };
  return {"components", read, written, &m.components_are_said};
}

/// Poisson's ratio of the change of thickness; the words stand for its ends.
YamlRow thickness_row(ForeignModel& m) {
  const std::vector<std::string> words{"constant", "incompressible"};
  const auto read = [&m, words](const Tree& tree, const std::string& key) {
    const auto word = std::ranges::find(words, tree.text);
    const bool number = tree.kind == Tree::Kind::scalar && word == words.end();
    if (tree.kind == Tree::Kind::scalar && word != words.end())
      m.thickness = word == words.begin() ? 0 : 0.5;
    else if (number && parse_number(tree.text))
      m.thickness = number_value(tree, key, {.lower = -1, .upper = 0.5, .lower_open = true});
    else
      refuse_value(tree, key, "must be a Poisson's ratio or a word, found " + described(tree), joined(words));
  };
  const auto written = [&m, words] {
    if (!adapters::is_of_plane_stress(m)) return std::string();
    return m.thickness == 0.5 ? words[1] : m.thickness == 0 ? words[0] : yaml_number(m.thickness);
  };
  return {"thickness", read, written};
}

YamlRows rows_of_all(ForeignModel& m, Places& where) {
  return {text_row("symbol", m.symbol, true),
          properties_row(m, where),
          state_row(m, where),
          {"fields", [&](const Tree& tree, const std::string&) { read_host_fields(tree, m, where); },
           [&] { return host_fields_text(m); }},
          varying_row(m, where),
          hypothesis_row(m),
          symmetry_row(m),
          flags_row(m),
          {"units",
           [&](const Tree& tree, const std::string& key) {
             require_map(tree, key, "stress, time, length");
             read_only_rows(tree, key, rows_of(m.units));
           },
           [&] { return flow_map(rows_of(m.units)); }, &m.units_are_said},
          number_row("temperature", m.temperature, {}, &m.temperature_is_said)};
}

/// Of a routine of LS-DYNA: what stands behind crv depends on its release.
YamlRow arguments_row(ForeignModel& m) {
  const auto read = [&m](const Tree& tree, const std::string& key) {
    m.arguments = std::stoi(choice_value(tree, key, {"18", "16", "13", "12"}));
  };
  return {"arguments", read, [&m] { return std::to_string(m.arguments); }};
}

/// What keys_of_abaqus() names.
YamlRows rows_of_abaqus(ForeignModel& m) {
  return {word_row("kinematics", m.kinematics, words_of<adapters::Kinematics>()),
          word_row("axes", m.axes, words_of<adapters::Axes>()),
          count_row("step", m.step, most_foreign_components, true),
          count_row("noel", m.element, most_elements),
          count_row("npt", m.point, most_elements),
          word_row("elements", m.each_its_element, {"one", "each"}, &m.each_its_element),  // "one" is not written
          word_row("strain", m.finite_strain, {"small", "finite"}, &m.strain_is_said),
          components_row(m),
          thickness_row(m),
          number_row("characteristic_length", m.characteristic_length, positive),
          text_row("material_name", m.material_name, true),
          arguments_row(m)};
}

/// What holds between keys.
void check_keys(const Tree& root, const ForeignModel& model) {
  const bool umat = model.interface == ForeignInterface::umat;
  const auto refuse_if = [&](bool fault, const char* key, const char* what) {
    if (fault) refuse_value(*root.find(key), key, what);
  };
  constexpr std::size_t longest_name = 80;  // CMNAME
  refuse_if(model.interface == ForeignInterface::vumat && model.axes != adapters::Axes::fixed, "axes",
            "is for interfaces that leave the choice: the axes of a VUMAT are its own");
  refuse_if(model.interface != ForeignInterface::mfront && root.find("hypothesis"), "hypothesis",
            "is for MFront alone");
  refuse_if(model.each_its_element && !umat, "elements", "each is for UMATs alone: no other interface counts elements");
  refuse_if(root.find("thickness") && !adapters::is_of_plane_stress(model), "thickness",
            "is for a UMAT of plane stress alone (components: [3]): elsewhere the deformation tells the thickness");
  refuse_if(adapters::is_of_plane_stress(model) && !umat, "components", "3 is for UMATs alone");
  refuse_if(model.each_its_element && root.find("noel"), "noel", "contradicts elements: each");
  refuse_if(model.material_name.size() > longest_name, "material_name", "has more than 80 letters");
}

}  // namespace

const std::vector<std::string>& interface_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"native"};
    append_all(all, words_of<ForeignInterface>());
    return all;
  }();
  return names;
}

std::vector<std::string> keys_without_effect(const std::string& interface) {
  if (interface == "mfront") return keys_of_abaqus();
  std::vector<std::string> none{"arguments"};
  if (interface == "vumat") none.push_back("thickness");
  if (interface == "usermat")
    append_all(none, {"strain", "elements", "fields", "characteristic_length", "material_name", "thickness"});
  if (interface == "lsdyna") none = {"components", "elements", "fields", "material_name", "step", "npt", "thickness"};
  return none;
}

const std::vector<std::string>& foreign_keys() {
  static const std::vector<std::string> keys{"symbol",
                                             "properties",
                                             "state",
                                             "kinematics",
                                             "axes",
                                             "strain",
                                             "symmetry",
                                             "flags",
                                             "components",
                                             "thickness",
                                             "units",
                                             "temperature",
                                             "fields",
                                             "varying",
                                             "hypothesis",
                                             "step",
                                             "characteristic_length",
                                             "material_name",
                                             "noel",
                                             "npt",
                                             "elements",
                                             "arguments"};
  return keys;
}

const std::vector<std::string>& keys_of_abaqus() {
  static ForeignModel any;
  static const std::vector<std::string> keys = names_of(rows_of_abaqus(any));
  return keys;
}

std::string foreign_yaml(const ForeignModel& model) {
  ForeignModel m = model;
  Places unused;
  YamlRows rows = rows_of_all(m, unused);
  append_all(rows, rows_of_abaqus(m));
  const std::vector<std::string> none = keys_without_effect(word_of(m.interface));
  std::erase_if(rows, [&](const YamlRow& row) { return is_one_of(row.name, none); });
  return "interface: " + word_of(m.interface) + "\n" + yaml_lines_of(rows);
}

ForeignModel read_foreign(const Tree& root, const std::string& interface, const std::string& library,
                          const std::string& name, std::map<std::string, Location>& where) {
  ForeignModel model;
  model.interface = static_cast<ForeignInterface>(index_of(interface, interface_names()) - 1);
  model.library = library;
  model.name = name;
  model.doc = interface;
  const bool of_abaqus = model.interface != ForeignInterface::mfront;
  if (of_abaqus) model.symbol = interface == "lsdyna" ? "umat41_" : interface + "_";
  if (interface == "usermat") model.axes = adapters::Axes::corotational;
  if (!of_abaqus) model.temperature = room_temperature;
  read_rows(root, "", rows_of_all(model, where));
  read_rows(root, "", rows_of_abaqus(model));
  read_rows(root, "", {number_row("density", model.density, positive)});
  for (const Tree::Entry& entry : root.entries) where[entry.key] = entry.value.where;
  check_keys(root, model);
  return model;
}

}  // namespace assay::drivers
