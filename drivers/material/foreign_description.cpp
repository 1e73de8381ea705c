// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/foreign_description.hpp"

#include "drivers/format/yaml_writer.hpp"

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

struct UnitWord {
  const char* word;
  double si;
};

/// `value`: SI units in one of the model's.
YamlRow unit_row(const char* name, double& value, const std::vector<UnitWord>& units) {
  const std::vector<std::string> words = mapped(units, [](const UnitWord& unit) { return std::string(unit.word); });
  return {name,
          [=, &value](const Tree& tree, const std::string& key) {
            value = units[index_of(choice_value(tree, key, words), words)].si;
          },
          [=, &value] {
            const auto same = [&](const UnitWord& unit) { return unit.si == value; };
            return std::string(std::find_if(units.begin(), units.end(), same)->word);
          }};
}

YamlRows rows_of(adapters::ModelUnits& units) {
  constexpr double psi = 6894.757293168361, ksi = 6894757.293168361;  // [Pa]
  return {unit_row("stress", units.stress,
                   {{"Pa", 1}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"psi", psi}, {"ksi", ksi}}),
          unit_row("time", units.time, {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {"h", 3600}}),
          unit_row("length", units.length, {{"m", 1}, {"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}, {"in", 0.0254}})};
}

void read_host_fields(const Tree& tree, ForeignModel& model, Places& where) {
  require_map(tree, "fields", "the fields of the host, in the model's order: names and values");
  for (const Tree::Entry& entry : tree.entries) {
    where["fields." + entry.key] = entry.value.where;
    model.fields.push_back({entry.key, number_value(entry.value, "fields." + one_line(entry.key, 80))});
  }
}

std::string host_fields_text(const ForeignModel& model) {
  const auto pair = [](const auto& field) { return yaml_scalar(field.name) + ": " + yaml_number(field.value); };
  return model.fields.empty() ? "" : "{" + joined(model.fields, pair) + "}";
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
      m.components.push_back(std::stoi(choice_value(item, key, {"4", "6"})));
    if (m.components.empty()) refuse_value(tree, key, "must name 6, 4 or both");
  };
  const auto written = [&m] { return flow_list(mapped(m.components, [](int n) { return std::to_string(n); })); };
  return {"components", read, written, &m.components_are_said};
}

YamlRows rows_of_all(ForeignModel& m, Places& where) {
  return {text_row("symbol", m.symbol, true),
          properties_row(m, where),
          state_row(m, where),
          {"fields", [&](const Tree& tree, const std::string&) { read_host_fields(tree, m, where); },
           [&] { return host_fields_text(m); }},
          symmetry_row(m),
          flags_row(m),
          {"units",
           [&](const Tree& tree, const std::string& key) {
             require_map(tree, key, "stress, time, length");
             read_only_rows(tree, key, rows_of(m.units));
           },
           [&] { return flow_map(rows_of(m.units)); }},
          number_row("temperature", m.temperature, {}, &m.temperature_is_said)};
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
          number_row("characteristic_length", m.characteristic_length, positive),
          text_row("material_name", m.material_name, true)};
}

/// What holds between keys.
void check_keys(const Tree& root, const ForeignModel& model) {
  const bool umat = model.interface == ForeignInterface::umat;
  const auto refuse_if = [&](bool fault, const char* key, const char* what) {
    if (fault) refuse_value(*root.find(key), key, what);
  };
  constexpr std::size_t longest_name = 80;  // CMNAME
  refuse_if(model.axes != adapters::Axes::fixed && !umat, "axes",
            "is for UMATs alone: the axes of other interfaces are theirs");
  refuse_if(model.each_its_element && !umat, "elements", "each is for UMATs alone: no other interface counts elements");
  refuse_if(model.each_its_element && root.find("noel"), "noel", "contradicts elements: each");
  refuse_if(model.material_name.size() > longest_name, "material_name", "has more than 80 letters");
}

}  // namespace

const std::vector<std::string>& interface_names() {
  static const std::vector<std::string> names{"native", "umat", "vumat", "mfront"};
  return names;
}

const std::vector<std::string>& foreign_keys() {
  static const std::vector<std::string> keys{
      "symbol",        "properties", "state", "kinematics",  "axes",   "strain", "symmetry",
      "flags",         "components", "units", "temperature", "fields", "step",   "characteristic_length",
      "material_name", "noel",       "npt",   "elements"};
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
  return "interface: " + word_of(m.interface) + "\n" + yaml_lines_of(rows_of_all(m, unused)) +
         (m.interface == ForeignInterface::mfront ? "" : yaml_lines_of(rows_of_abaqus(m)));
}

ForeignModel read_foreign(const Tree& root, const std::string& interface, const std::string& library,
                          const std::string& name, std::map<std::string, Location>& where) {
  ForeignModel model;
  model.interface = static_cast<ForeignInterface>(index_of(interface, interface_names()) - 1);
  model.library = library;
  model.name = name;
  model.doc = interface;
  const bool of_abaqus = model.interface != ForeignInterface::mfront;
  if (of_abaqus) model.symbol = interface + "_";
  if (!of_abaqus) model.temperature = room_temperature;
  read_rows(root, "", rows_of_all(model, where));
  read_rows(root, "", rows_of_abaqus(model));
  read_rows(root, "", {number_row("density", model.density, positive)});
  for (const Tree::Entry& entry : root.entries) where[entry.key] = entry.value.where;
  check_keys(root, model);
  return model;
}

}  // namespace assay::drivers
