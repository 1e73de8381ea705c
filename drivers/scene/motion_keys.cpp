// SPDX-License-Identifier: BSD-3-Clause
// The keys of `motion`, of which each motion's record has its own.
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

#include "drivers/text/words.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/motion/registry.hpp"

namespace assay::drivers {

namespace {

/// The words of motion.type of all motions for which something holds.
std::vector<std::string> types_of(bool (*holds)(const Motion&)) {
  std::vector<std::string> types;
  for (const Motion& sample : motion_registry().samples()) {
    if (holds(sample)) types.emplace_back(sample->type());
  }
  return types;
}

/// The keys of one motion, in its order.
std::vector<Key> keys_of_motion(const Motion& motion) {
  std::vector<Key> keys = keys_of("motion", motion, &Scene::motion);
  for (Key& key : keys) key.motions = {std::string(motion->type())};
  return keys;
}

/// The keys of all motions, each once: a motion that has it later adds its word. The order within each motion stays.
std::vector<Key> keys_of_motions() {
  std::vector<Key> all;
  const auto place = [&](const std::string& path) {
    return std::find_if(all.begin(), all.end(), [&](const Key& key) { return key.path == path; });
  };
  for (const Motion& motion : motion_registry().samples()) {
    const std::vector<Key> own = keys_of_motion(motion);
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (const auto same = place(own[k].path); same != all.end()) {
        same->motions.push_back(own[k].motions.front());
        if (own[k].unit != same->unit) same->unit_of_motion[own[k].motions.front()] = own[k].unit;
        continue;
      }
      auto before = all.end();
      for (std::size_t next = k + 1; next < own.size() && before == all.end(); ++next) before = place(own[next].path);
      all.insert(before, own[k]);
    }
  }
  return all;
}

void set_motion(Scene& s, const Value& v) {
  for (const Motion& sample : motion_registry().samples()) {
    if (sample->type() == std::get<std::string>(v)) s.motion = sample;
  }
}

Key key_of_type() {
  const auto get = [](const Scene& s) { return Value(motion_type(s)); };
  Key key = key_row("motion.type", "which manufactured motion the body follows", KeyType::choice, {.required = true},
                    get, set_motion);
  key.choices = types_of([](const Motion&) { return true; });
  return key;
}

/// Without a table the motion refuses motion.interpolation. The reader reads the file when it knows where the scene
/// lies.
std::vector<Key> keys_of_table() {
  const auto table_of = [](auto& s) { return s.motion.template as<DeformationTable>(); };
  const auto path = [=](const Scene& s) { return table_of(s) ? Value(table_of(s)->source()) : Value(); };
  const auto interpolation = [=](const Scene& s) {
    return table_of(s) ? value_of(table_of(s)->interpolation()) : Value();
  };
  const auto interpolate = [=](Scene& s, const Value& v) {
    if (!table_of(s)) return;
    Interpolation given{};
    give(given, v);
    s.motion = table_of(s)->interpolated(given);
  };
  const auto time_unit = [=](const Scene& s) {
    return table_of(s) && s.path_time != Units().time ? Value(s.path_time) : Value();
  };
  static constexpr auto interpolations = names_of(Interpolation{});
  const auto of_table = [] { return std::vector<std::string>{"homogeneous"}; };
  std::vector<Key> keys{
      key_row("motion.path",
              "CSV file of F(t), in place of motion.final; columns t, F11, F12, F21, F22, others optional",
              KeyType::text, {.derived = "none: F goes straight to final", .motions = of_table}, path,
              [](Scene& s, const Value& v) { s.motion = DeformationTable(std::get<std::string>(v)); }),
      key_row("motion.interpolation",
              "F between the rows of motion.path: straight lines, PCHIP (no overshoot) or a cubic spline",
              KeyType::choice,
              {.choices = interpolations,
               .derived = "linear for tabulate, monotone for what needs a body force",
               .motions = of_table},
              interpolation, interpolate),
      key_row("motion.time_unit", "unit of the column t of motion.path where its header says none", KeyType::choice,
              {.derived = "units.time", .motions = of_table}, time_unit,
              [](Scene& s, const Value& v) { s.path_time = std::get<std::string>(v); })};
  keys.back().choices = unit_words("s");
  return keys;
}

}  // namespace

std::vector<Key> motion_keys() {
  std::vector<Key> keys{key_of_type()}, of_motions = keys_of_motions();
  const auto instead =
      std::find_if(of_motions.begin(), of_motions.end(), [](const Key& key) { return key.path == "motion.final"; });
  const std::vector<Key> of_table = keys_of_table();
  of_motions.insert(instead, of_table.begin(), of_table.end());
  append_all(keys, of_motions);
  return keys;
}

std::vector<std::string> loaded_motions() {
  return types_of([](const Motion& motion) { return motion->bears_tractions(); });
}

std::vector<std::string> repeating_motions() {
  return types_of([](const Motion& motion) { return motion->may_repeat(); });
}

std::vector<std::string> vortex_motions() { return types_of(is_vortex); }

std::vector<std::string> motions_with_outside() {
  return types_of([](const Motion& motion) { return is_vortex(motion) || motion.as<Vortex3d>(); });
}

std::string motion_type(const Scene& scene) { return std::string(scene.motion->type()); }

}  // namespace assay::drivers
