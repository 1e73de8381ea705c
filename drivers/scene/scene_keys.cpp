// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/scene_keys.hpp"

#include <algorithm>

#include "drivers/text/words.hpp"
#include "mpm/compose.hpp"

namespace assay::drivers {

namespace {

/// A part of a scene, with its keys. An optional one is absent unless it is written.
Section section(const std::string& path, const std::string& doc, auto part) {
  auto sample = std::invoke(part, Scene());
  Section made{.path = path, .doc = doc};
  if constexpr (Optional<decltype(sample)>::value) {
    sample.emplace();
    made.begin = [part](Scene& scene) { std::invoke(part, scene).emplace(); };
  }
  made.keys = keys_of(path, sample, part);
  return made;
}

/// The keys that the scene itself shows under a section ("" is the top).
std::vector<Key> own_keys(const std::string& section) {
  std::vector<Key> keys = keys_of("", Scene(), std::identity());
  std::erase_if(keys, [&](const Key& key) { return parent_of(key.path) != section; });
  return keys;
}

std::vector<Key> unit_keys();

std::vector<Section> all_sections() {
  std::vector<Key> of_motion = motion_keys();
  append_all(of_motion, own_keys("motion"));
  Section frame =
      section("frame", "observer's frame, for the vortex and with dimension: 3; without it: the body's own frame",
              &Scene::frame);
  for (Key& key : frame.keys) key.motions = vortex_motions(), key.all_motions_in_space = true;
  Section body = section("body", "the particles", &Scene::body);
  for (Key& key : body.keys) key.all_motions_in_space = key.path == "body.periodic";
  Section material = section("material", "the constitutive model", &Scene::material);
  material.required = true;
  return {
      {.path = "units",
       .doc = "units of the scene's numbers; a mass is a stress times length times time squared; without it: SI",
       .keys = unit_keys()},
      {.path = "motion", .doc = "the manufactured motion", .required = true, .keys = of_motion},
      {.path = "motion.amplitude", .doc = "amplitude g(t) of the motion"},
      frame,
      material,
      {.path = "material.parameters",
       .doc = "material parameters by name, in the units of the scene; of a foreign model in those of its description",
       .free_keys = true},
      body,
      section(
          "body.initial_velocity",
          "initial velocity of a free body, with force.response: none; without it: that of the motion",
          [](auto&& scene) -> auto& { return scene.body.initial_velocity; }),
      section("grid", "the background grid", &Scene::grid),
      section("method", "the particle method; without it, a scene can only be tabulated, evaluated and checked",
              &Scene::method),
      section("force", "the body force", &Scene::force),
      section("traction", "how prescribed tractions act on the grid", &Scene::traction),
      {.path = "remedies",
       .doc = "cures for known weaknesses of a method; each has a cost, and none is on by default",
       .keys = keys_of("", mpm::EffectOptions(), &Scene::effects)},
      section("time", "duration and time steps", &Scene::time),
      section("output", "what is written", &Scene::output),
      section("limits", "limits on the memory and the work of a run", &Scene::limits),
      {.path = "expect", .doc = "expected results, by key of result.json", .free_keys = true},
  };
}

/// They are not written: a scene that is written in full is in SI.
std::vector<Key> unit_keys() {
  const auto row = [](const char* name, const char* doc, const char* si, std::string Units::*word) {
    Key key = key_row(
        key_path("units", name), doc, KeyType::choice, {.derived = si}, [](const Scene&) { return Value(); },
        [word](Scene& scene, const Value& value) { scene.units.*word = std::get<std::string>(value); });
    key.choices = unit_words(si);
    return key;
  };
  return {row("length", "unit of all lengths", "m", &Units::length),
          row("stress", "unit of all stresses and moduli", "Pa", &Units::stress),
          row("time", "unit of all times", "s", &Units::time)};
}

/// Whether a list, of all where it is empty, has the word.
bool admits(const std::vector<std::string>& list, const std::string& word) {
  return list.empty() || is_one_of(word, list);
}

}  // namespace

void show(mpm::EffectOptions& options, Keys& visitor) {
  for (const auto& effect : mpm::effects<2>()) {
    if (effect.keys) effect.keys(options, visitor);
  }
}

Key key_row(const std::string& path, std::string_view doc, KeyType type, const KeyRules& rules, Get get, Set set) {
  const auto words = [](KeyRules::Words list) { return list ? list() : std::vector<std::string>(); };
  return {.path = path,
          .type = type,
          .doc = std::string(doc),
          .unit = rules.unit,
          .range = rules.range,
          .choices = {rules.choices.begin(), rules.choices.end()},
          .required = rules.required,
          .derived = rules.derived,
          .motions = words(rules.motions),
          .domains = words(rules.domains),
          .get = std::move(get),
          .set = std::move(set)};
}

std::vector<Key> item_rows(const KeyInfo& list) {
  std::vector<Key> rows;
  if (!list.item) return rows;
  EachKey each([&](const KeyInfo& info, KeyType type, const Value& value) -> EachKey::Answer {
    const auto get = [value = info.shown ? value : Value()](const Scene&) { return value; };
    rows.push_back(key_row(std::string(info.name), info.doc, type, info, get, {}));
    return std::nullopt;
  });
  list.item(each);
  return rows;
}

std::vector<Key> rows_of_part(const std::string& section, const std::function<void(Keys&)>& sample,
                              const std::function<void(const Scene&, Keys&)>& look,
                              const std::function<void(Scene&, Keys&)>& change) {
  std::vector<Key> rows;
  EachKey each([&](const KeyInfo& info, KeyType type, const Value&) -> EachKey::Answer {
    const std::string name(info.name);
    const auto get = [name, look](const Scene& scene) {
      Value found;
      EachKey visitor([&](const KeyInfo& key, KeyType, const Value& value) -> EachKey::Answer {
        if (key.shown && key.name == name) found = value;
        return std::nullopt;
      });
      look(scene, visitor);
      return found;
    };
    const auto set = [name, change](Scene& scene, const Value& value) {
      EachKey visitor([&](const KeyInfo& key, KeyType, const Value&) {
        return key.name == name ? EachKey::Answer(value) : std::nullopt;
      });
      change(scene, visitor);
    };
    rows.push_back(key_row(key_path(section, name), info.doc, type, info, get, set));
    rows.back().items = item_rows(info);
    return std::nullopt;
  });
  sample(each);
  return rows;
}

const std::vector<Section>& scene_sections() {
  static const std::vector<Section> sections = all_sections();
  return sections;
}

const std::vector<Key>& scene_keys() {
  static const std::vector<Key> keys = [] {
    std::vector<Key> all = own_keys("");
    for (const Section& section : scene_sections()) append_all(all, section.keys);
    return all;
  }();
  return keys;
}

std::string unit_of(const Key& key, const Scene& scene) {
  const auto own = key.unit_of_motion.find(motion_type(scene));
  const std::string& unit = own == key.unit_of_motion.end() ? key.unit : own->second;
  return unit.empty() ? "1" : unit;
}

std::string doc_of(const Key& key) {
  if (key.unit.empty()) return key.doc;
  std::map<std::string, std::vector<std::string>> motions;
  for (const auto& [motion, unit] : key.unit_of_motion) motions[unit].push_back(motion);
  std::string units = key.unit;
  for (const auto& [unit, all] : motions) units += "; " + unit + " of " + joined(all);
  const std::size_t end = std::min(key.doc.find(';'), key.doc.size());
  return key.doc.substr(0, end) + " [" + units + "]" + key.doc.substr(end);
}

bool of_motion(const Key& key, const Scene& scene) {
  return admits(key.motions, motion_type(scene)) || (key.all_motions_in_space && scene.dimension == 3);
}

bool applies(const Key& key, const Scene& scene) {
  return of_motion(key, scene) && admits(key.domains, domain_name(scene.body.domain));
}

bool applies(const Section& section, const Scene& scene) {
  const auto& keys = scene_keys();
  return section.free_keys || std::any_of(keys.begin(), keys.end(), [&](const Key& key) {
           return key.path.starts_with(section.path + ".") && applies(key, scene);
         });
}

std::vector<std::string> names_under(const std::string& section, const Scene* scene) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& path) {
    if (parent_of(path) == section) names.push_back(last_part(path));
  };
  for (const Key& key : scene_keys()) {
    if (!scene || applies(key, *scene)) add(key.path);
  }
  for (const Section& part : scene_sections()) {
    if (!scene || applies(part, *scene)) add(part.path);
  }
  return names;
}

std::vector<std::string> item_names(const Key& list) { return mapped(list.items, &Key::path); }

std::string domain_name(Body::Domain domain) { return word_of(domain); }

}  // namespace assay::drivers
