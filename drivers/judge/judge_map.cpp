// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/judge/judge_map.hpp"

#include <algorithm>
#include <fstream>
#include <optional>

#include "drivers/format/unit_rows.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// One text, or a list of them.
std::vector<std::string> texts_value(const Tree& tree, const std::string& key) {
  if (tree.kind != Tree::Kind::sequence) return {text_value(tree, key)};
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < tree.items.size(); ++k) texts.push_back(text_value(tree.items[k], item_path(key, k)));
  if (texts.empty()) refuse_value(tree, key, "must name an array, or a column for each component");
  return texts;
}

YamlRow texts_row(const char* name, std::vector<std::string>& value) {
  return {name, [&value](const Tree& tree, const std::string& key) { value = texts_value(tree, key); },
          [] { return std::string(); }};
}

std::vector<double> list_value(const Tree& tree, const std::string& key) {
  std::vector<double> values;
  if (tree.kind != Tree::Kind::sequence) refuse_value(tree, key, "must be a list of numbers, found " + described(tree));
  for (std::size_t k = 0; k < tree.items.size(); ++k) values.push_back(number_value(tree.items[k], item_path(key, k)));
  return values;
}

const std::vector<std::string> sources{"guess", "header", "column", "name", "step", "list"};

YamlRows rows_of(JudgeTime& time) {
  return {word_row("from", time.from, sources),
          text_row("column", time.column),
          text_row("pattern", time.pattern),
          number_row("step", time.step),
          number_row("start", time.start),
          {"values", [&](const Tree& tree, const std::string& key) { time.values = list_value(tree, key); },
           [] { return std::string(); }},
          number_row("velocity", time.velocity)};
}

YamlRows rows_of(JudgeCost& cost) {
  return {{"seconds",
           [&](const Tree& tree, const std::string& key) {
             cost.seconds = tree.kind == Tree::Kind::sequence ? list_value(tree, key)
                                                              : std::vector<double>{number_value(tree, key)};
             for (const double seconds : cost.seconds) {
               if (!(seconds > 0)) refuse_value(tree, key, "must be above 0");
             }
           },
           [] { return std::string(); }},
          number_row("cores", cost.cores, positive),
          text_row("machine", cost.machine)};
}

/// What `from` needs, and what only one of them has.
void check_time(const Tree& tree, const std::string& path, JudgeTime& time) {
  using From = JudgeTime::From;
  const auto needs = [&](From from, bool given, const char* key, const char* what) {
    if (time.from == from && !given)
      refuse_value(tree, path,
                   std::string("from: ") + sources[static_cast<std::size_t>(from)] + " needs " + key + ", " + what);
    if (time.from == From::guess && given) time.from = from;
  };
  needs(From::list, !time.values.empty(), "values", "the times of the tables in their order");
  needs(From::column, !time.column.empty(), "column", "the name of the column");
  needs(From::name, !time.pattern.empty(), "pattern", "a regular expression with a group around the number");
  if ((time.from == From::step) && !(time.step > 0))
    refuse_value(tree, path, "from: step needs step, the time between two numbers");
}

YamlRows rows_of_all(JudgeMap& map) {
  YamlRows rows{text_row("code", map.code)};
  for (std::size_t k = 0; k < judged_quantities; ++k)
    rows.push_back(texts_row(names_of(Judged{})[k].c_str(), map.of[k]));
  const auto group = [](const char* name, const auto& read) {
    return YamlRow{name, read, [] { return std::string(); }};
  };
  rows.push_back(group("sigma_components", [&map](const Tree& tree, const std::string& key) {
    for (const double value : list_value(tree, key)) {
      const int component = static_cast<int>(value), row = component / 10, column = component % 10;
      if (component != value || row < 1 || row > 3 || column < 1 || column > 3)
        refuse_value(tree, key, "must be a list of 11, 22, 33, 12, ...");
      map.sigma_components.push_back(component);
    }
  }));
  rows.push_back(texts_row("columns", map.columns));
  rows.push_back(group("units", [&map](const Tree& tree, const std::string& key) {
    require_map(tree, key, "length, time, velocity, stress");
    double velocity = 0;
    std::vector<std::string> lengths = unit_words("m");
    lengths.emplace_back("km");
    read_only_rows(tree, key,
                   {unit_row("length", map.length, lengths), unit_row("time", map.time_unit, unit_words("s")),
                    unit_row("velocity", velocity, {"m/s", "mm/s", "cm/s", "um/s", "km/s"}),
                    unit_row("stress", map.stress, unit_words("Pa"))});
    if (velocity > 0) map.velocity = velocity;
  }));
  rows.push_back(group("time", [&map](const Tree& tree, const std::string& key) {
    require_map(tree, key, "from, column, pattern, step, start, values, velocity");
    read_only_rows(tree, key, rows_of(map.time));
    check_time(tree, key, map.time);
  }));
  rows.push_back(text_row("seeds", map.seeds));
  rows.push_back(text_row("scene_sha256", map.scene_sha256));
  rows.push_back(group("cost", [&map](const Tree& tree, const std::string& key) {
    require_map(tree, key, "seconds, cores, machine");
    read_only_rows(tree, key, rows_of(map.cost));
  }));
  return rows;
}

/// What codes write by themselves, as far as their names are their own.
const std::vector<std::pair<std::string, std::string>>& presets() {
  static const std::vector<std::pair<std::string, std::string>> all{
      {"lammps", "code: LAMMPS\nid: id\nx: [x, y, z]\nv: [vx, vy, vz]\n"},
      {"karamelo",
       "code: Karamelo\nid: id\nX: [x0, y0, z0]\nx: [x, y, z]\nv: [vx, vy, vz]\n"
       "sigma: [s11, s22, s33, s12, s13, s23]\nvolume: volume\n"},
      {"nairn", "code: NairnMPM\nid: id\nX: [X, Y]\nx: [x, y]\nv: [vx, vy]\ntime: {from: column, column: t}\n"},
      {"fenics", "code: FEniCSx\nid: id\nX: X\nx: x\nv: v\n"},
      {"abaqus", "code: Abaqus\nid: id\nX: [X1, X2, X3]\nu: [U1, U2, U3]\n"}};
  return all;
}

/// Names that codes use, the most telling ones first. A list of one is an array, or a column of a single number.
const std::vector<std::vector<std::string>>& usual_names(Judged quantity) {
  using Names = std::vector<std::vector<std::string>>;
  static const std::array<Names, judged_quantities> all{
      Names{
          {"id"}, {"tag"}, {"ID"}, {"particle_id"}, {"particleId"}, {"pid"}, {"particle"}, {"p.particleID"}, {"index"}},
      Names{{"X"},
            {"X", "Y", "Z"},
            {"X", "Y"},
            {"X1", "X2", "X3"},
            {"x0", "y0", "z0"},
            {"x0", "y0"},
            {"px0", "py0", "pz0"},
            {"px0", "py0"},
            {"X0"},
            {"reference_position"},
            {"initial_position"},
            {"position0"}},
      Names{{"x"},
            {"x", "y", "z"},
            {"x", "y"},
            {"Points"},
            {"position"},
            {"positions"},
            {"coordinates"},
            {"p.x"},
            {"pos_x", "pos_y", "pos_z"},
            {"pos_x", "pos_y"},
            {"xu", "yu", "zu"},
            {"px", "py", "pz"},
            {"px", "py"}},
      Names{{"u"},
            {"displacement"},
            {"u", "v", "w"},
            {"ux", "uy", "uz"},
            {"ux", "uy"},
            {"U1", "U2", "U3"},
            {"U1", "U2"},
            {"p.displacement"}},
      Names{{"v"},
            {"velocity"},
            {"vx", "vy", "vz"},
            {"vx", "vy"},
            {"V1", "V2", "V3"},
            {"velx", "vely", "velz"},
            {"velx", "vely"},
            {"vel_x", "vel_y", "vel_z"},
            {"vel_x", "vel_y"},
            {"p.velocity"},
            {"velocities"}},
      Names{{"F"},
            {"deformation_gradient"},
            {"defgrad"},
            {"F11", "F12", "F13", "F21", "F22", "F23", "F31", "F32", "F33"},
            {"F11", "F12", "F21", "F22"},
            {"Fxx", "Fxy", "Fyx", "Fyy"},
            {"p.deformationMeasure"}},
      Names{{"J"}, {"jacobian"}, {"detF"}, {"det_F"}},
      Names{{"sigma"},
            {"stress"},
            {"cauchy_stress"},
            {"s11", "s22", "s33", "s12", "s13", "s23"},
            {"s11", "s22", "s33", "s12"},
            {"s11", "s22", "s12"},
            {"sxx", "syy", "szz", "sxy", "sxz", "syz"},
            {"sxx", "syy", "sxy"},
            {"S11", "S22", "S33", "S12"},
            {"p.stress"}},
      Names{{"V"}, {"volume"}, {"V0"}, {"vol"}, {"volume0"}, {"p.volume"}}};
  return all[static_cast<std::size_t>(quantity)];
}

bool fits(const ParticleTable& table, const std::vector<std::string>& names, Judged quantity) {
  const bool number = quantity == Judged::id || quantity == Judged::J || quantity == Judged::volume;
  for (const std::string& name : names) {
    const ParticleArray* array = table.array(name);
    if (!array) return false;
    if (names.size() > 1 ? array->components != 1 : (array->components == 1) != number) return false;
  }
  return true;
}

}  // namespace

const std::vector<std::string>& names_of(Judged) {
  static const std::vector<std::string> names{"id", "X", "x", "u", "v", "F", "J", "sigma", "volume"};
  return names;
}

std::vector<std::string> judge_presets() {
  return mapped(presets(), [](const auto& each) { return each.first; });
}

JudgeMap read_judge_map(const std::string& file_or_preset) {
  const auto preset = std::ranges::find_if(presets(), [&](const auto& each) { return each.first == file_or_preset; });
  const bool is_preset = preset != presets().end();
  if (!is_preset && file_or_preset.find_first_of("./") == std::string::npos && !std::ifstream(file_or_preset))
    throw InputError({}, "--map", "'" + shown(file_or_preset, 40) + "' is no file and no code that is known",
                     joined(judge_presets()));
  JudgeMap map;
  const Tree root = read_yaml(is_preset ? preset->second : read_bytes(file_or_preset), file_or_preset);
  require_map(root, "", joined(names_of(rows_of_all(map))));
  read_only_rows(root, "", rows_of_all(map));
  return map;
}

JudgeCost read_judge_cost(const std::string& file) {
  JudgeCost cost;
  const Tree root = read_yaml(read_bytes(file), file);
  require_map(root, "", "seconds, cores, machine");
  read_only_rows(root, "", rows_of(cost));
  return cost;
}

void complete_map(JudgeMap& map, const ParticleTable& table) {
  for (std::size_t k = 0; k < judged_quantities; ++k) {
    const auto quantity = static_cast<Judged>(k);
    if (!map.of[k].empty()) continue;
    const auto& known = usual_names(quantity);
    const auto found = std::ranges::find_if(known, [&](const auto& names) { return fits(table, names, quantity); });
    const bool taken =
        found != known.end() && std::ranges::any_of(map.of, [&](const auto& names) { return names == *found; });
    if (found != known.end() && !taken) map.of[k] = *found;
  }
  if (!map.names(Judged::x).empty() || !map.names(Judged::u).empty()) return;
  throw InputError({table.file, 0, 0}, "",
                   "neither positions nor displacements are recognised: a map says `x: [NAME, NAME]`",
                   joined(table.arrays, [](const ParticleArray& array) { return shown(array.name, 40); }));
}

namespace {

std::string words_of_list(const std::vector<std::string>& names) {
  std::string words;
  for (const std::string& name : names) words += (words.empty() ? "" : " ") + name;
  return words;
}

}  // namespace

std::string map_words(const JudgeMap& map) {
  std::string words;
  for (std::size_t k = 0; k < judged_quantities; ++k) {
    if (map.of[k].empty()) continue;
    words += (words.empty() ? "" : ", ") + names_of(Judged{})[k] + " is " + words_of_list(map.of[k]);
  }
  return words;
}

}  // namespace assay::drivers
