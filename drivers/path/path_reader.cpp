// SPDX-License-Identifier: BSD-3-Clause
// The scene of a path, read strictly.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "drivers/format/unit_rows.hpp"
#include "drivers/path/path_result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

const std::vector<std::string> top_keys{"title",    "units",   "material",   "path",      "stages",
                                        "variants", "compare", "increments", "iso_error", "expect"};
const std::vector<std::string> stop_words{"above", "below", "peak", "loss_of_ellipticity"};

constexpr int most_rows = 100'000;
constexpr double most_seconds = 1e9;

std::vector<std::string> type_words() {
  std::vector<std::string> words;
  for (const PathType& type : path_types()) words.emplace_back(type.word);
  return words;
}

/// By the reader of scenes, so that the keys of a material mean the same here.
MaterialChoice read_material(const Tree& tree, const Tree& root, const std::string& file) {
  if (const Tree* stress = tree.find("initial_stress"))
    throw InputError(stress->where, "material.initial_stress", "is path.initial_stress where a point takes a path");
  Tree motion, type;
  type.kind = Tree::Kind::scalar, type.text = "rigid", type.where = tree.where;
  motion.kind = Tree::Kind::map, motion.where = tree.where;
  motion.entries.push_back({"type", tree.where, type});
  Tree scene;
  scene.kind = Tree::Kind::map, scene.where = root.where;
  if (const Tree* units = root.find("units")) scene.entries.push_back({"units", units->where, *units});
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
  variant.where = tree.where;
  Tree material = base;
  for (const Tree::Entry& entry : tree.entries) {
    if (entry.key == "label") {
      variant.label = text_value(entry.value, key_path(path, "label")), variant.where = entry.value.where;
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

/// Of the last one: one line, and no other has it.
void check_label(std::vector<PathVariant>& variants, const std::string& path) {
  PathVariant& last = variants.back();
  const std::string key = key_path(path, "label");
  if (last.label.empty()) last.label = "variant " + std::to_string(variants.size());
  if (one_line(last.label, last.label.size()) != last.label)
    throw InputError(last.where, key, "must be one line of text, found '" + shown(last.label, 80) + "'");
  if (std::ranges::count(variants, last.label, &PathVariant::label) > 1)
    throw InputError(last.where, key, "'" + shown(last.label, 80) + "' is the label of another variant");
}

PathStop read_stop(const Tree& tree, const std::string& path, const Units& units) {
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
    stop.quantity = in_si(quantity_at(text_value(entry.value, key), entry.value.where, key), units);
    return stop;
  }
  require_map(entry.value, key, "a quantity and its bound, as {s11: 1.0e+6}");
  if (entry.value.entries.size() != 1) throw InputError(entry.value.where, key, "takes one quantity");
  const Tree::Entry& bound = entry.value.entries[0];
  stop.quantity = in_si(quantity_at(bound.key, bound.key_where, key), units);
  stop.bound =
      units.scale(si_unit_of(kind_of(stop.quantity))).to_si(number_value(bound.value, key_path(key, bound.key)));
  return stop;
}

void read_stops(const Tree& tree, PathScene& scene) {
  const std::string path = key_path(scene.section, "stop");
  if (tree.kind != Tree::Kind::sequence) {
    scene.stops.push_back(read_stop(tree, path, scene.units));
    return;
  }
  for (std::size_t i = 0; i < tree.items.size(); ++i)
    scene.stops.push_back(read_stop(tree.items[i], item_path(path, i), scene.units));
}

void read_control(const Tree& tree, PathScene& scene) {
  const std::string path = key_path(scene.section, "control");
  require_map(tree, path, "rows, as e11: 0.1 and s22: 0");
  for (const Tree::Entry& entry : tree.entries) {
    const std::string key = key_path(path, entry.key);
    PathRow row{
        in_si(quantity_at(entry.key, entry.key_where, key), scene.units), {}, PathRow::Origin::given, entry.key_where};
    row.value = read_path_function(entry.value, key, entry.key, kind_of(row.quantity), scene.units);
    scene.rows.push_back(std::move(row));
  }
}

void set_measures(const Location& where, PathScene& scene) {
  std::vector<PathQuantity> quantities;
  for (const PathRow& row : scene.rows) quantities.push_back(row.quantity);
  std::string fault;
  const auto measures = measures_of(quantities, fault);
  if (!measures) throw InputError(where, key_path(scene.section, "control"), fault);
  const bool of_shear = is_one_of(scene.type, {"simple_shear", "torsion", "pure_shear"});
  scene.deformation =
      measures->deformation.value_or(of_shear ? Deformation::gradient : Deformation::logarithmic_strain);
  scene.stress = measures->stress.value_or(StressMeasure::cauchy);
  for (const PathStop& stop : scene.stops) {
    for (const PathTerm& term : stop.quantity.terms) {
      if (term.of_J()) continue;
      const char* letter = term.of_stress() ? letter_of(scene.stress) : letter_of(scene.deformation);
      if (term.family != letter)
        throw InputError(stop.where, key_path(scene.section, "stop"),
                         "asks for " + term.family + ", and the path is controlled by " + letter);
    }
  }
}

void read_path(const Tree& tree, PathScene& scene) {
  require_map(tree, scene.section, "type, control, end, rows, ...");
  const Scale stress = scene.units.scale("Pa"), time = scene.units.scale("s");
  const auto read_initial = [&](const Tree& value, const std::string& key) {
    const auto six = numbers_value(value, key, 1, 6);
    for (std::size_t k = 0; k < six.size(); ++k) scene.initial_stress[k] = stress.to_si(six[k]);
    scene.initial_where = value.where;
  };
  double confinement = NAN, end = 0;
  const auto read_type = [&](const Tree& value, const std::string& key) {
    scene.type = choice_value(value, key, type_words(), "docs/paths.md");
  };
  YamlRows rows{{"type", read_type, nullptr}};
  rows.push_back({"initial_stress", read_initial, nullptr});
  rows.push_back(number_row("confinement", confinement));
  rows.push_back(number_row("end", end, in_units({.lower = 0, .upper = most_seconds, .lower_open = true}, time)));
  rows.push_back(count_row("rows", scene.count, most_rows));
  rows.push_back(number_row("calls", scene.most_calls, {.lower = 1, .upper = 1e12}));
  rows.push_back(number_row("tolerance", scene.tolerance, {.lower = 1e-14, .upper = 1e-2}));
  rows.push_back({"control", [&](const Tree& value, const std::string&) { read_control(value, scene); }, nullptr});
  rows.push_back({"fields", [&](const Tree& value, const std::string&) { read_path_fields(value, scene); }, nullptr});
  rows.push_back({"stop", [&](const Tree& value, const std::string&) { read_stops(value, scene); }, nullptr});
  read_only_rows(tree, scene.section, rows);
  const Tree* control = tree.find("control");
  if (!control) throw InputError(tree.where, key_path(scene.section, "control"), "required and not given");
  scene.where = control->where;
  if (std::isfinite(confinement)) {
    if (!is_one_of(scene.type, {"triaxial", "undrained_triaxial"}))
      throw InputError(tree.find("confinement")->where, key_path(scene.section, "confinement"),
                       "belongs to path.type triaxial and undrained_triaxial");
    if (tree.find("initial_stress"))
      throw InputError(tree.find("confinement")->where, key_path(scene.section, "confinement"),
                       "cannot be combined with initial_stress");
    scene.confinement = stress.to_si(confinement), scene.initial_where = tree.find("confinement")->where;
    for (std::size_t k = 0; k < 3; ++k) scene.initial_stress[k] = -*scene.confinement;
  }
  end = time.to_si(end);
  scene.end = end;
  for (const PathRow& row : scene.rows) scene.end = end > 0 ? end : std::max(scene.end, row.value.last());
  for (const PathField& field : scene.fields) scene.end = end > 0 ? end : std::max(scene.end, field.value.last());
  if (scene.end == 0) scene.end = 1;
  if (scene.end > most_seconds)
    throw InputError(control->where, key_path(scene.section, "control"),
                     "goes on until " + scene.units.text(scene.end, "s") + ": 1e9 s at most");
  for (const PathRow& row : scene.rows)
    check_times(row.value, key_path(key_path(scene.section, "control"), row.quantity.text), scene);
  check_path_fields(scene);
  set_measures(control->where, scene);
  complete_rows(scene, control->where);
  warn_of_swings(scene);
}

/// One path after the other: the first is the scene's own.
void read_stages(const Tree& tree, const Tree& root, PathScene& scene) {
  for (const char* other : {"path", "increments", "iso_error"}) {
    if (const Tree* found = root.find(other)) throw InputError(found->where, other, "cannot be combined with stages");
  }
  if (tree.kind != Tree::Kind::sequence || tree.items.empty())
    throw InputError(tree.where, "stages", "must be a list of paths, each with type, control, end ...");
  for (std::size_t i = 0; i < tree.items.size(); ++i) {
    PathScene& stage = i == 0 ? scene : scene.later.emplace_back();
    stage.section = item_path("stages", i), stage.file = scene.file, stage.units = scene.units;
    read_path(tree.items[i], stage);
    if (!stage.fields.empty())
      throw InputError(stage.fields[0].where, key_path(stage.section, "fields"), "cannot be combined with stages");
    if (i > 0 && !stage.initial_where.file.empty())
      throw InputError(stage.initial_where, stage.section, "begins with the stress in which the stage before it ends");
    if (i > 0) scene.warnings.insert(scene.warnings.end(), stage.warnings.begin(), stage.warnings.end());
  }
}

}  // namespace

bool is_path_scene(const Tree& root) {
  return root.kind == Tree::Kind::map && (root.find("path") || root.find("stages")) && !root.find("motion");
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
  scene.units = scene.material.units;
  if (const Tree* stages = root.find("stages")) {
    read_stages(*stages, root, scene);
  } else {
    read_path(*root.find("path"), scene);
  }
  if (const Tree* variants = root.find("variants")) {
    if (variants->kind != Tree::Kind::sequence) throw InputError(variants->where, "variants", "must be a list of maps");
    for (std::size_t i = 0; i < variants->items.size(); ++i) {
      const std::string path = item_path("variants", i);
      scene.variants.push_back(read_variant(variants->items[i], path, *material, root, file));
      scene.variants.back().material.varying = scene.material.varying;
      check_label(scene.variants, path);
    }
  }
  if (const Tree* compare = root.find("compare")) read_compare(*compare, scene);
  if (const Tree* increments = root.find("increments")) read_increments(*increments, scene);
  if (const Tree* map = root.find("iso_error")) read_iso_error(*map, scene);
  if (const Tree* expect = root.find("expect")) {
    ExpectationWords words;
    words.of_runs = false, words.outcomes = path_outcomes(), words.numbers = path_figure_keys(*expect, scene.variants);
    scene.expect = read_expectations(*expect, words);
  }
  return scene;
}

}  // namespace assay::drivers
