// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_reader.hpp"

#include <algorithm>
#include <filesystem>

#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/key_values.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "drivers/text/unseen.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

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

/// Where the key itself stands; of the whole its beginning.
Location key_place(const Tree& root, const std::string& path) {
  const Tree* map = path.find('.') == path.npos ? &root : value_at(root, parent_of(path));
  const std::string name = last_part(path);
  for (const Tree::Entry& entry : map ? map->entries : std::vector<Tree::Entry>{}) {
    if (entry.key == name) return entry.key_where;
  }
  return root.where;
}

/// Every section is a map, and every key is one that some scene may have.
void check_names(const Tree& root) {
  require_map(root, "", joined(names_under("")));
  refuse_other_keys(root, "", names_under(""));
  for (const Section& section : scene_sections()) {
    const Tree* map = value_at(root, section.path);
    if (!map) continue;
    const std::vector<std::string> known = names_under(section.path);
    require_map(*map, section.path, joined(known));
    if (!section.free_keys) refuse_other_keys(*map, section.path, known);
  }
}

/// Then the body and the grid are in space, too. Without a method they are of no account there.
bool runs_in_space(const Scene& scene) { return scene.dimension == 3 && scene.method; }

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
    const bool by_axes = key.type == KeyType::per_axis && (scene.dimension == 2 || runs_in_space(scene));
    const auto axes = static_cast<std::size_t>(scene.dimension);
    const std::string unit = unit_of(key, scene);
    const Scale scale = scene.units.scale(unit);
    key.set(scene, by_axes
                       ? in_si(key, numbers_value(*tree, key.path, 1, axes, in_units(key.range, scale)), scale, *tree)
                       : read_value(key, *tree, scene.units, unit));
    scene.places.merge(places_of_value(key, *tree));
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
  material.units = scene.units;
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
  if (!value_at(root, "motion.time_unit")) scene.path_time = scene.units.time;
  scene.motion = read_deformation_table(table, interpolation, scene.path_time);
  const Tree* period = value_at(root, "motion.period");
  const double last = scene.motion->period();
  if (period && scene.units.scale("s").to_si(number_value(*period, "motion.period")) != last) {
    throw InputError(period->where, "motion.period",
                     "is the time of the last row of motion.path, " + scene.units.text(last, "s") + ": leave it out");
  }
}

/// What dimension and body are unless the scene says otherwise.
void begin_motion(Scene& scene) {
  if (scene.motion->only_in_space() && !scene.places.contains("dimension")) scene.dimension = 3;
  Body& body = scene.body;
  if (!ring_of(scene.motion)) body.domain = Body::Domain::square;
  body.lower = scene.motion->usual_lower(), body.upper = scene.motion->usual_upper();
  const int axes = runs_in_space(scene) ? 3 : 2;
  for (PerAxis<double>* corner : {&body.lower, &body.upper}) corner->set_dimension(axes);
  body.per_cell.set_dimension(axes);
  if (scene.grid) scene.grid->offset.set_dimension(axes);
  if (axes == 3) body.domain = scene.motion.as<Vortex3d>() ? Body::Domain::vortex : Body::Domain::box;
}

/// Whether b is so smooth that at points it is as good as its means, which are far dearer in space.
bool is_smooth_in_space(const Scene& scene) {
  if (scene.dimension != 3) return false;
  if (const auto* plane = scene.motion.as<Vortex>()) return plane->profile_power >= Revolution::usual_power;
  const auto* vortex = scene.motion.as<Vortex3d>();
  return !vortex || std::ranges::all_of(vortex->all(), &Revolution::has_smooth_edge);
}

/// Defaults that follow from other keys.
void derive(const Tree& root, Scene& scene) {
  if (!value_at(root, "body.outside")) {
    const bool has_outside = is_vortex(scene.motion) || scene.motion.as<Vortex3d>();
    const bool holds = has_outside && !scene.body.is_vortex_alone();
    scene.body.outside = holds ? Body::Outside::held : Body::Outside::free;
  }
  if (!value_at(root, "force.evaluation") && is_smooth_in_space(scene)) {
    scene.force.evaluation = ForceChoice::Evaluation::point;
  }
  if (!value_at(root, "body.cut")) {
    const bool average = scene.force.evaluation == ForceChoice::Evaluation::domain_average;
    const bool loaded = scene.bears_tractions();  // on the ring's faces
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
  if (const Tree* expect = value_at(root, "expect"))
    scene.expect = read_expectations(*expect, {.numbers = {order_key, last_order_key}, .units = scene.units});
  check_scene(scene, [&](const std::string& path) {
    auto found = scene.places.find(path);
    if (found == scene.places.end()) found = scene.places.find(parent_of(path));
    return found == scene.places.end() ? root.where : found->second;
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
