// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_reader.hpp"

#include <algorithm>
#include <filesystem>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

/// The value at a dotted path of table keys, null where there is none.
const Tree* value_at(const Tree& root, const std::string& path) {
  const Tree* at = &root;
  for (std::size_t begin = 0; at && begin <= path.size();) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    at = at->find(std::string_view(path).substr(begin, dot - begin));
    begin = dot + 1;
  }
  return at;
}

Value read_value(const Key& key, const Tree& tree) {
  switch (key.type) {
    case KeyType::number:
      return number_value(tree, key.path, key.range);
    case KeyType::automatic:
      if (tree.kind == Tree::Kind::scalar && tree.text == "auto") return {};
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
    case KeyType::pair_or_vector:
      return numbers_value(tree, key.path, 1, tree.items.size() == 3 ? 3 : 2, key.range);
    case KeyType::matrix:
      return numbers_value(tree, key.path, 3, 3, key.range);
  }
  return {};
}

/// Where the key itself stands; of the whole its beginning.
Location key_place(const Tree& root, const std::string& path) {
  const Tree* map = path.find('.') == path.npos ? &root : value_at(root, parent_of(path));
  const std::string name = last_part(path);
  for (const Tree::Entry& entry : map ? map->entries : std::vector<Tree::Entry>{}) {
    if (entry.key == name) return entry.key_where;
  }
  return root.where;
}

/// Where a key belongs that this section has not; empty where nothing is known.
std::string place_of(const Tree::Entry& entry, const std::string& section, const std::vector<std::string>& here) {
  const std::vector<std::string> top = names_under("");
  if (!section.empty() && std::find(top.begin(), top.end(), entry.key) != top.end())
    return "unknown key here: it belongs to the scene itself, beside " + section.substr(0, section.find('.'));
  for (const Key& key : scene_keys()) {
    const bool common = entry.key == "type" || entry.key == "final" || entry.key == "path";
    if (common || last_part(key.path) != entry.key) continue;
    return "unknown key here: it belongs to " + parent_of(key.path);
  }
  const bool number = entry.value.kind == Tree::Kind::scalar && parse_number(entry.value.text);
  const bool parameter = section == "material" && number && nearest(entry.key, here).empty();
  return parameter ? "unknown key: parameters of the model belong to material.parameters" : "";
}

/// A key that stands in the wrong section.
void refuse_misplaced_keys(const Tree& map, const std::string& section) {
  const std::vector<std::string> here = names_under(section);
  for (const Tree::Entry& entry : map.entries) {
    if (std::find(here.begin(), here.end(), entry.key) != here.end()) continue;
    const std::string what = place_of(entry, section, here);
    if (what.empty()) continue;
    throw InputError(entry.key_where, key_path(section, shown(entry.key, 80)), what, joined(here));
  }
}

/// Every section is a map, and every key is one that some scene may have.
void check_names(const Tree& root) {
  require_map(root, "", joined(names_under("")));
  refuse_misplaced_keys(root, "");
  refuse_unknown_keys(root, "", names_under(""));
  for (const Section& section : scene_sections()) {
    const Tree* map = value_at(root, section.path);
    if (!map) continue;
    require_map(*map, section.path, joined(names_under(section.path)));
    if (section.free_keys) continue;
    refuse_misplaced_keys(*map, section.path);
    refuse_unknown_keys(*map, section.path, names_under(section.path));
  }
}

void read_key(const Key& key, const Tree& root, Scene& scene) {
  const Tree* tree = value_at(root, key.path);
  const std::string parent = parent_of(key.path);
  if (tree && !applies(key, scene)) {
    const std::string why =
        of_motion(key, scene) ? "body.domain " + domain_name(scene.body.domain) : "motion.type " + motion_type(scene);
    throw InputError(key_place(root, key.path), key.path, "does not belong to " + why,
                     joined(names_under(parent, &scene)));
  }
  if (tree) {
    const Value value = read_value(key, *tree);
    if (value.index() != 0) key.set(scene, value);
    scene.places[key.path] = tree->where;
  } else if (key.required && applies(key, scene)) {
    const Tree* section = parent.empty() ? &root : value_at(root, parent);
    if (section) throw InputError(section->where, key.path, "required and not given");
  }
}

void begin_sections(const Tree& root, Scene& scene) {
  for (const Section& section : scene_sections()) {
    const Tree* map = value_at(root, section.path);
    if (!map) {
      if (section.required) throw InputError(root.where, section.path, "required and not given");
      continue;
    }
    if (section.begin) section.begin(scene);
    scene.places[section.path] = map->where;
  }
}

/// From which a relative path counts: the file's folder; of settings the working directory.
std::filesystem::path folder_of(const Location& where) {
  return where.file == set_option ? std::filesystem::path() : std::filesystem::path(where.file).parent_path();
}

void read_material(const Tree& root, Scene& scene) {
  MaterialChoice& material = scene.material;
  const Tree& adapter = *value_at(root, "material.adapter");
  material.where = adapter.where;
  material.adapter = absolute_material(material.adapter, folder_of(adapter.where));
  const Tree* parameters = value_at(root, "material.parameters");
  if (!parameters) return;
  for (const Tree::Entry& entry : parameters->entries) {
    const std::string remedy =
        parse_number(entry.key) ? ": numbers have a decimal point, and a comma ends a value" : key_remedy(entry.key);
    if (entry.value.kind == Tree::Kind::null && !remedy.empty())
      throw InputError(entry.key_where, "material.parameters." + one_line(entry.key, 80),
                       "must be a number, found nothing" + remedy);
    material.parameters[entry.key] = number_value(entry.value, "material.parameters." + one_line(entry.key, 80));
    material.parameter_where[entry.key] = entry.value.where;
    material.parameter_key_where[entry.key] = entry.key_where;
  }
}

/// The table behind motion.path; a period beside it must be the table's own.
void read_motion_path(const Tree& root, Interpolation otherwise, Scene& scene) {
  const Tree* given = value_at(root, "motion.path");
  if (!given) return;
  const auto& named = *scene.motion.as<DeformationTable>();
  const Interpolation interpolation = value_at(root, "motion.interpolation") ? named.interpolation() : otherwise;
  const std::string table = absolute_path(folder_of(given->where) / named.source());
  if (const std::string fault = fault_of_file(table); !fault.empty()) {
    throw InputError(given->where, "motion.path", fault);
  }
  scene.motion = read_deformation_table(table, interpolation);
  const Tree* period = value_at(root, "motion.period");
  const double last = scene.motion->period();
  if (period && number_value(*period, "motion.period") != last) {
    throw InputError(period->where, "motion.period",
                     "is the time of the last row of motion.path, " + number_text(last) + ": leave it out");
  }
}

/// What dimension and body are unless the scene says otherwise.
void begin_motion(Scene& scene) {
  if (scene.motion->only_in_space() && !scene.places.contains("dimension")) scene.dimension = 3;
  if (!ring_of(scene.motion)) scene.body.domain = Body::Domain::square;
  scene.body.lower = scene.motion->usual_lower(), scene.body.upper = scene.motion->usual_upper();
}

/// Defaults that follow from other keys.
void derive(const Tree& root, Scene& scene) {
  if (!value_at(root, "body.outside")) {
    const bool ring = scene.body.domain == Body::Domain::ring;
    const bool holds = is_vortex(scene.motion) && !ring;
    scene.body.outside = holds ? Body::Outside::held : Body::Outside::free;
  }
  if (!value_at(root, "body.cut")) {
    const bool average = scene.force.evaluation == ForceChoice::Evaluation::domain_average;
    const bool loaded = scene.motion->bears_tractions();  // on the ring's faces
    scene.body.cut = average || loaded ? Body::Cut::clipped : Body::Cut::whole;
  }
  if (!value_at(root, "time.end")) scene.time.end = scene.motion->period();
}

}  // namespace

Scene scene_of(const Tree& root, const std::string& file, const std::string& sha256, Interpolation otherwise) {
  check_names(root);
  Scene scene;
  scene.file = file;
  scene.sha256 = sha256;
  begin_sections(root, scene);
  for (const Key& key : scene_keys()) {
    read_key(key, root, scene);
    if (key.path == "motion.type") begin_motion(scene);
  }
  read_material(root, scene);
  read_motion_path(root, otherwise, scene);
  scene.motion->set_dimension(scene.dimension);
  derive(root, scene);
  if (const Tree* expect = value_at(root, "expect")) scene.expect = read_expectations(*expect);
  check_scene(scene, [&](const std::string& path) {
    const Tree* tree = value_at(root, path);
    if (!tree) tree = value_at(root, parent_of(path));
    return tree ? tree->where : root.where;
  });
  return scene;
}

Tree scene_tree(std::string_view text, const std::string& file) {
  Tree root = read_yaml(text, file);
  if (root.kind == Tree::Kind::null) throw InputError({file, 0, 0}, "", "empty");
  require_map(root, "", joined(names_under("")));
  refuse_other_kind(root, FileKind::scene);
  return root;
}

Scene scene_from_text(std::string_view text, const std::string& file, const std::vector<std::string>& sets,
                      Interpolation otherwise) {
  Tree root = scene_tree(text, file);
  for (const std::string& setting : sets) apply_setting(root, parse_setting(setting));
  return scene_of(root, file, sha256_hex(text), otherwise);
}

Scene read_scene(const std::string& file, const std::vector<std::string>& sets, Interpolation otherwise) {
  return scene_from_text(read_bytes(file), file, sets, otherwise);
}

}  // namespace assay::drivers
