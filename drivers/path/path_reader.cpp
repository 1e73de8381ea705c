// SPDX-License-Identifier: BSD-3-Clause
// The scene of a path, read strictly.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/path/path_result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

const std::vector<std::string> top_keys{"title",   "material",   "path",      "variants",
                                        "compare", "increments", "iso_error", "expect"};
const std::vector<std::string> stop_words{"above", "below", "peak", "loss_of_ellipticity"};

constexpr int most_rows = 100'000, most_map_points = 101;
constexpr double most_seconds = 1e9;

std::vector<std::string> type_words() {
  std::vector<std::string> words;
  for (const PathType& type : path_types()) words.emplace_back(type.word);
  return words;
}

PathQuantity quantity_of(const std::string& text, const Location& where, const std::string& key) {
  std::string fault;
  const auto quantity = parse_quantity(text, fault);
  if (!quantity) throw InputError(where, key, fault, known_quantities);
  return *quantity;
}

/// By the reader of scenes, so that the keys of a material mean the same here.
MaterialChoice read_material(const Tree& tree, const Tree& root, const std::string& file) {
  Tree motion, type;
  type.kind = Tree::Kind::scalar, type.text = "rigid", type.where = tree.where;
  motion.kind = Tree::Kind::map, motion.where = tree.where;
  motion.entries.push_back({"type", tree.where, type});
  Tree scene;
  scene.kind = Tree::Kind::map, scene.where = root.where;
  scene.entries.push_back({"motion", tree.where, motion});
  scene.entries.push_back({"material", tree.where, tree});
  MaterialChoice material = scene_of(scene, file, {}).material;
  material.needs_density = false;
  return material;
}

/// What the variant says, in place of what the base says.
PathVariant read_variant(const Tree& tree, const std::string& path, const Tree& base, const Tree& root,
                         const std::string& file) {
  require_map(tree, path, "label, and keys of material");
  PathVariant variant;
  Tree material = base;
  for (const Tree::Entry& entry : tree.entries) {
    if (entry.key == "label") {
      variant.label = text_value(entry.value, key_path(path, "label"));
      continue;
    }
    Tree* there = material.find(entry.key);
    if (!there) {
      material.entries.push_back(entry);
    } else if (entry.key == "parameters" && there->kind == Tree::Kind::map && !tree.find("adapter")) {
      for (const Tree::Entry& parameter : entry.value.entries) {
        if (Tree* value = there->find(parameter.key)) {
          *value = parameter.value;
        } else {
          there->entries.push_back(parameter);
        }
      }
    } else {
      *there = entry.value;
    }
  }
  variant.material = read_material(material, root, file);
  return variant;
}

PathStop read_stop(const Tree& tree, const std::string& path) {
  PathStop stop;
  stop.where = tree.where;
  if (tree.kind == Tree::Kind::scalar) {
    choice_value(tree, path, {"loss_of_ellipticity"}, "docs/paths.md");
    stop.when = ControlStop::When::loss_of_ellipticity;
    return stop;
  }
  require_map(tree, path, "peak: s11, or above: {s11: 1.0e+6}, or below");
  refuse_unknown_keys(tree, path, {"above", "below", "peak"});
  if (tree.entries.size() != 1) throw InputError(tree.where, path, "takes one of above, below, peak");
  const Tree::Entry& entry = tree.entries[0];
  const std::string key = key_path(path, entry.key);
  stop.when = static_cast<ControlStop::When>(index_of(entry.key, stop_words));
  if (stop.when == ControlStop::When::peak) {
    stop.quantity = quantity_of(text_value(entry.value, key), entry.value.where, key);
    return stop;
  }
  require_map(entry.value, key, "a quantity and its bound, as {s11: 1.0e+6}");
  if (entry.value.entries.size() != 1) throw InputError(entry.value.where, key, "takes one quantity");
  const Tree::Entry& bound = entry.value.entries[0];
  stop.quantity = quantity_of(bound.key, bound.key_where, key);
  stop.bound = number_value(bound.value, key_path(key, bound.key));
  return stop;
}

void read_stops(const Tree& tree, PathScene& scene) {
  const std::string path = "path.stop";
  if (tree.kind != Tree::Kind::sequence) {
    scene.stops.push_back(read_stop(tree, path));
    return;
  }
  for (std::size_t i = 0; i < tree.items.size(); ++i)
    scene.stops.push_back(read_stop(tree.items[i], item_path(path, i)));
}

void read_control(const Tree& tree, PathScene& scene) {
  const std::string path = "path.control";
  require_map(tree, path, "rows, as e11: 0.1 and s22: 0");
  for (const Tree::Entry& entry : tree.entries) {
    const std::string key = key_path(path, entry.key);
    PathRow row{quantity_of(entry.key, entry.key_where, key), read_path_function(entry.value, key),
                PathRow::Origin::given, entry.key_where};
    if (row.value.type == PathFunction::Type::file) read_history_file(row.value, entry.key, key, kind_of(row.quantity));
    scene.rows.push_back(std::move(row));
  }
}

void set_measures(const Location& where, PathScene& scene) {
  std::vector<PathQuantity> quantities;
  for (const PathRow& row : scene.rows) quantities.push_back(row.quantity);
  std::string fault;
  const auto measures = measures_of(quantities, fault);
  if (!measures) throw InputError(where, "path.control", fault);
  const bool of_shear = is_one_of(scene.type, {"simple_shear", "torsion", "pure_shear"});
  scene.deformation =
      measures->deformation.value_or(of_shear ? Deformation::gradient : Deformation::logarithmic_strain);
  scene.stress = measures->stress.value_or(StressMeasure::cauchy);
  for (const PathStop& stop : scene.stops) {
    for (const PathTerm& term : stop.quantity.terms) {
      const char* letter = term.of_stress() ? letter_of(scene.stress) : letter_of(scene.deformation);
      if (term.family != letter)
        throw InputError(stop.where, "path.stop",
                         "asks for " + term.family + ", and the path is controlled by " + letter);
    }
  }
}

void read_path(const Tree& tree, PathScene& scene) {
  require_map(tree, "path", "type, control, end, rows, ...");
  std::vector<double> stress;
  const auto read_initial = [&](const Tree& value, const std::string& key) {
    const auto six = numbers_value(value, key, 1, 6);
    std::copy(six.begin(), six.end(), scene.initial_stress.begin());
  };
  double confinement = NAN, end = 0;
  const auto read_type = [&](const Tree& value, const std::string& key) {
    scene.type = choice_value(value, key, type_words(), "docs/paths.md");
  };
  YamlRows rows{{"type", read_type, nullptr}};
  rows.push_back({"initial_stress", read_initial, nullptr});
  rows.push_back(number_row("confinement", confinement));
  rows.push_back(number_row("end", end, {.lower = 0, .upper = most_seconds, .lower_open = true}));
  rows.push_back(count_row("rows", scene.count, most_rows));
  rows.push_back(number_row("calls", scene.most_calls, {.lower = 1, .upper = 1e12}));
  rows.push_back(number_row("tolerance", scene.tolerance, {.lower = 1e-14, .upper = 1e-2}));
  rows.push_back({"control", [&](const Tree& value, const std::string&) { read_control(value, scene); }, nullptr});
  rows.push_back({"stop", [&](const Tree& value, const std::string&) { read_stops(value, scene); }, nullptr});
  read_only_rows(tree, "path", rows);
  const Tree* control = tree.find("control");
  if (!control) throw InputError(tree.where, "path.control", "required and not given");
  if (std::isfinite(confinement)) {
    if (!is_one_of(scene.type, {"triaxial", "undrained_triaxial"}))
      throw InputError(tree.find("confinement")->where, "path.confinement",
                       "belongs to path.type triaxial and undrained_triaxial");
    if (tree.find("initial_stress"))
      throw InputError(tree.find("confinement")->where, "path.confinement", "cannot be combined with initial_stress");
    scene.confinement = confinement;
    for (std::size_t k = 0; k < 3; ++k) scene.initial_stress[k] = -confinement;
  }
  scene.end = end;
  for (const PathRow& row : scene.rows) scene.end = end > 0 ? end : std::max(scene.end, row.value.last());
  if (scene.end == 0) scene.end = 1;
  if (scene.end > most_seconds)
    throw InputError(control->where, "path.control", "goes on until " + number_text(scene.end) + " s: 1e9 s at most");
  for (const PathRow& row : scene.rows) check_times(row, scene.end);
  set_measures(control->where, scene);
  complete_rows(scene, control->where);
  warn_of_swings(scene);
}

void read_compare(const Tree& tree, PathScene& scene) {
  require_map(tree, "compare", "file, x, y");
  PathComparison compare;
  compare.where = tree.where;
  std::string x = "t", y;
  const auto read_file = [&](const Tree& value, const std::string& key) {
    const auto folder = std::filesystem::path(value.where.file).parent_path();
    compare.file = absolute_path(folder / text_value(value, key));
    if (const std::string fault = fault_of_file(compare.file); !fault.empty())
      throw InputError(value.where, key, fault);
  };
  compare.y_of_x.where = tree.where;
  std::string x_column, y_column;
  read_only_rows(tree, "compare",
                 {{"file", read_file, nullptr},
                  text_row("x", x),
                  text_row("y", y),
                  text_row("x_column", x_column),
                  text_row("y_column", y_column)});
  for (const char* name : {"file", "y"}) {
    if (!tree.find(name)) throw InputError(tree.where, key_path("compare", name), "required and not given");
  }
  if (x != "t") compare.x = quantity_of(x, tree.find("x")->where, "compare.x");
  compare.y = quantity_of(y, tree.find("y")->where, "compare.y");
  compare.y_of_x.type = PathFunction::Type::file;
  compare.y_of_x.file = compare.file;
  compare.y_of_x.time = x_column.empty() ? x : x_column;
  compare.y_of_x.column = y_column;
  read_history_file(compare.y_of_x, y, "compare", kind_of(compare.y),
                    compare.x.terms.empty() ? HistoryKind::time : kind_of(compare.x));
  scene.compare = std::move(compare);
}

/// A list of numbers of increments, ascending.
void read_increments(const Tree& tree, PathScene& scene) {
  const std::string key = "increments";
  if (tree.kind != Tree::Kind::sequence) throw InputError(tree.where, key, "must be a list, as [10, 20, 40]");
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    const double count = number_value(tree.items[i], item_path(key, i), {.lower = 1, .upper = 1e6, .whole = true});
    if (i > 0 && count <= scene.increments.back())
      throw InputError(tree.items[i].where, item_path(key, i), "must be more than the one before");
    scene.increments.push_back(static_cast<int>(count));
  }
  if (scene.increments.empty()) throw InputError(tree.where, key, "is empty");
}

void read_iso_error(const Tree& tree, PathScene& scene) {
  const std::string key = "iso_error";
  require_map(tree, key, "from, unit, reach, points");
  IsoErrorChoice choice;
  const auto read_from = [&](const Tree& value, const std::string& path) {
    const auto two = numbers_value(value, path, 1, 2);
    choice.e11 = two[0], choice.e22 = two[1];
  };
  read_only_rows(tree, key,
                 {{"from", read_from, nullptr},
                  number_row("unit", choice.unit, {.lower = 0, .upper = 1, .lower_open = true}),
                  number_row("reach", choice.reach, {.lower = 0, .upper = 1000, .lower_open = true}),
                  count_row("points", choice.points, most_map_points)});
  for (const char* name : {"from", "unit"}) {
    if (!tree.find(name)) throw InputError(tree.where, key_path(key, name), "required and not given");
  }
  if (choice.points < 2) throw InputError(tree.find("points")->where, "iso_error.points", "must be 2 at least");
  if (std::abs(choice.e11) > 1 || std::abs(choice.e22) > 1 || choice.unit * choice.reach > 1)
    throw InputError(tree.where, key, "leaves strains below 1");
  scene.iso_error = choice;
}

}  // namespace

bool is_path_scene(const Tree& root) {
  return root.kind == Tree::Kind::map && root.find("path") && !root.find("motion");
}

PathScene path_scene_of(const Tree& root, const std::string& file, const std::string& sha256) {
  require_map(root, "", joined(top_keys));
  refuse_unknown_keys(root, "", top_keys);
  PathScene scene;
  scene.file = file, scene.sha256 = sha256;
  if (const Tree* title = root.find("title")) scene.title = text_value(*title, "title");
  const Tree* material = root.find("material");
  if (!material) throw InputError(root.where, "material", "required and not given");
  scene.material = read_material(*material, root, file);
  read_path(*root.find("path"), scene);
  if (const Tree* variants = root.find("variants")) {
    if (variants->kind != Tree::Kind::sequence) throw InputError(variants->where, "variants", "must be a list of maps");
    for (std::size_t i = 0; i < variants->items.size(); ++i) {
      const std::string path = item_path("variants", i);
      scene.variants.push_back(read_variant(variants->items[i], path, *material, root, file));
      if (scene.variants.back().label.empty()) scene.variants.back().label = "variant " + std::to_string(i + 1);
    }
  }
  if (const Tree* compare = root.find("compare")) read_compare(*compare, scene);
  if (const Tree* increments = root.find("increments")) read_increments(*increments, scene);
  if (const Tree* map = root.find("iso_error")) read_iso_error(*map, scene);
  if (const Tree* expect = root.find("expect")) {
    ExpectationWords words;
    words.of_runs = false, words.outcomes = path_outcomes(), words.numbers = path_figure_keys(*expect);
    scene.expect = read_expectations(*expect, words);
  }
  return scene;
}

}  // namespace assay::drivers
