// SPDX-License-Identifier: BSD-3-Clause
// Scenes in the units of their author: every committed scene, written in others, is the same scene; and what is written
// so is the same physics, whatever it is called.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "drivers/material/material_choice.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/text/units.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "tests/drivers/author_text.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_scene_units {
namespace {

/// No product of powers of their sizes is 1, so that none is taken for another.
const Units author{.length = "in", .stress = "ksi", .time = "min"};
const Units mm_MPa_ms{.length = "mm", .stress = "MPa", .time = "ms"};
const std::string head = "units: {" + mm_MPa_ms.words() + "}\n";

/// Other units than the keys say, for what goes wrong.
using Planted = std::map<std::string, std::string>;

Value from_si(const Value& value, const Scale& scale) {
  if (const auto* number = std::get_if<double>(&value)) return scale.from_si(*number);
  const auto* list = std::get_if<std::vector<double>>(&value);
  if (!list) return value;
  std::vector<double> own;
  for (const double number : *list) own.push_back(scale.from_si(number));
  return own;
}

/// The scene in full, its numbers in the author's units, without a word of these.
std::string in_author_units(Scene scene, const Planted& planted = {}) {
  const Scene si = scene;
  for (const Key& key : scene_keys()) {
    if (!applies(key, si) || key.path.ends_with("type")) continue;
    Value value = key.get(si);
    if (value.index() == 0) continue;
    if (auto* items = std::get_if<std::vector<KeyRecord>>(&value)) {
      for (KeyRecord& item : *items) {
        for (auto& [name, part] : item.values) {
          for (const Key& row : key.items)
            if (row.path == name) part = from_si(part, author.scale(row.unit));
        }
      }
    }
    const auto other = planted.find(key.path);
    value = from_si(value, author.scale(other == planted.end() ? unit_of(key, si) : other->second));
    key.set(scene, value);
  }
  for (Expectation& line : scene.expect) {
    const Scale scale = author_unit(line.key, author).scale;
    line.number = scale.from_si(line.number), line.upper = scale.from_si(line.upper);
  }
  const Material material = resolve_material(si.material).material;
  for (const assay_parameter& parameter : std::span(material.table().parameters, material.table().parameter_count)) {
    const auto given = scene.material.parameters.find(parameter.name);
    if (given != scene.material.parameters.end()) given->second = author.scale(parameter.unit).from_si(given->second);
  }
  return resolved_yaml(scene);
}

/// Committed scenes with models of the program. A table of F has its times in a file.
std::vector<std::string> plain_configs() {
  std::vector<std::string> files;
  for (const std::string& file : all_configs()) {
    const Scene scene = read_scene(file);
    if (!parse_material(scene.material.adapter).is_path && !scene.motion.as<DeformationTable>()) files.push_back(file);
  }
  return files;
}

/// The scene as it is when its material is known.
std::string whole(Scene scene) {
  scene.material = resolve_material(scene.material).choice;
  return resolved_yaml(scene);
}

TEST(SceneUnits, EveryCommittedSceneIsTheSameInOthers) {
  std::set<std::string> converted;
  const auto files = plain_configs();
  EXPECT_GT(files.size(), 60u);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const Scene si = read_scene(file);
    const Scene read = scene_from_text("units: {" + author.words() + "}\n" + in_author_units(si), file);
    EXPECT_EQ(read.units, author);
    expect_same_text(whole(read), whole(si));
    for (const Key& key : scene_keys()) {
      if (applies(key, si) && key.get(si).index() != 0) converted.insert(key.path);
    }
  }
  for (const Key& key : scene_keys()) {
    const bool has_dimension = !author.scale(key.unit).is_one();
    const bool rare = key.path.starts_with("motion.") && key.type != KeyType::list;  // below, in every motion
    if (has_dimension && !rare && key.path != "time.step" && !key.path.starts_with("output.")) {
      EXPECT_TRUE(converted.contains(key.path)) << key.path << " is in no committed scene";
    }
  }
}

/// What is counted, and speeds over the author's unit of speed.
struct Posed {
  std::int64_t particles, steps;
  double wave, particle, period;
};
Posed posed(const Scene& scene, const Scale& speed, const Scale& time) {
  return in_dimension(scene, [&]<int Dim>(std::integral_constant<int, Dim>) {
    const auto problem = assemble<Dim>(scene, 1);
    return Posed{problem.particles(), problem.steps, speed.from_si(problem.wave_speed),
                 speed.from_si(problem.particle_speed), time.from_si(problem.period())};
  });
}

/// The text without a word of its units is another scene of the same physics: all that has no dimension is the same, by
/// the equations alone and not by what the keys say. A motion in the unit box knows the metre.
std::string difference(const std::string& file, const Planted& planted = {}) {
  constexpr double rounding = 1e-9;  // of speeds, which are searched for on the path
  const Scene si = read_scene(file);
  const Posed a = posed(si, author.scale("m/s"), author.scale("s"));
  Posed b{};
  const std::string refusal =
      refusal_of([&] { b = posed(scene_from_text(in_author_units(si, planted), file), {}, {}); });
  if (refusal != "accepted") return refusal;
  const auto differ = [&](double x, double y) {
    return std::abs(x - y) > rounding * std::max(std::abs(x), std::abs(y));
  };
  std::string text;
  if (a.particles != b.particles) text += " particles";
  if (std::abs(a.steps - b.steps) > 1) text += " steps";  // a rounding may add one
  if (differ(a.wave, b.wave)) text += " wave";
  if (differ(a.particle, b.particle)) text += " particle";
  if (differ(a.period, b.period)) text += " period";
  return text;
}

TEST(SceneUnits, TheKeysHaveTheDimensionsOfThePhysics) {
  int compared = 0;
  for (const std::string& file : plain_configs()) {
    const Scene scene = read_scene(file);
    if (!scene.method || is_box(scene.motion) || scene.dimension == 3) continue;
    EXPECT_EQ(difference(file), "") << file;
    ++compared;
  }
  EXPECT_GT(compared, 30);
  const std::string vortex = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
  for (const auto& [key, wrong] :
       Planted{{"material.density", "kg/m^2"}, {"grid.spacing", "s"}, {"motion.period", "m"}})
    EXPECT_NE(difference(vortex, {{key, wrong}}), "") << key;
}

// By hand: what each number of a scene measures. A key with a unit that is missing here, or with another, is seen.
TEST(SceneUnits, EveryKeyHasItsUnit) {
  const std::map<std::string, std::string> units{{"motion.inner", "m"},
                                                 {"motion.outer", "m"},
                                                 {"motion.period", "s"},
                                                 {"motion.amplitude.peak", "rad"},
                                                 {"motion.final", "1"},
                                                 {"motion.expansion", "m"},
                                                 {"motion.wave_speed", "m/s"},
                                                 {"motion.factors", "1"},
                                                 {"motion.stretch", "1"},
                                                 {"motion.shear", "1"},
                                                 {"motion.rotation", "rad"},
                                                 {"motion.velocity", "m/s"},
                                                 {"motion.spin", "rad/s"},
                                                 {"motion.center", "m"},
                                                 {"motion.strength", "1"},
                                                 {"motion.radius", "m"},
                                                 {"motion.ring_radius", "m"},
                                                 {"motion.height", "m"},
                                                 {"motion.vortices[].radius", "m"},
                                                 {"motion.vortices[].ring_radius", "m"},
                                                 {"motion.vortices[].height", "m"},
                                                 {"motion.vortices[].center", "m"},
                                                 {"motion.vortices[].strength", "1"},
                                                 {"frame.angle", "rad"},
                                                 {"frame.spin", "rad/s"},
                                                 {"frame.velocity", "m/s"},
                                                 {"material.density", "kg/m^3"},
                                                 {"material.initial_stress", "Pa"},
                                                 {"body.lower", "m"},
                                                 {"body.upper", "m"},
                                                 {"body.initial_velocity.velocity", "m/s"},
                                                 {"body.initial_velocity.spin", "rad/s"},
                                                 {"body.initial_velocity.stretching", "1/s"},
                                                 {"grid.spacing", "m"},
                                                 {"grid.lower", "m"},
                                                 {"grid.upper", "m"},
                                                 {"time.end", "s"},
                                                 {"time.step", "s"},
                                                 {"output.each_step_from", "s"}};
  std::map<std::string, std::string> found;
  const auto note = [&](const std::string& path, const Key& key) {
    for (const char* unit : {"[m]", "[s]", "[Pa]", "[m/s]", "[rad]", "[kg/m^3]"})
      EXPECT_EQ(key.doc.find(unit), key.doc.npos) << path << ": its unit stands beside the text, in KeyRules";
    if (!key.unit.empty()) found[path] = key.unit;
  };
  for (const Key& key : scene_keys()) {
    note(key.path, key);
    for (const Key& item : key.items) note(key.path + "[]." + item.path, item);
  }
  EXPECT_EQ(found, units);
  const Scene box = scene_from_text(
      "motion: {type: axis_aligned, wave_speed: 1}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n",
      "f");
  for (const Key& key : scene_keys()) {
    if (key.path != "motion.amplitude.peak") continue;
    EXPECT_EQ(unit_of(key, box), "m");
  }
}

TEST(SceneUnits, RangesAreThoseOfTheAuthor) {
  EXPECT_EQ(refusal_of([] { scene_from_text(head + scene_text("grid: {spacing: 0}\n"), "f"); }),
            "f:4:17: grid.spacing: must be greater than 0, found '0'");
  EXPECT_EQ(scene_from_text(head + scene_text("grid: {spacing: 50}\n"), "f").grid->spacing, 0.05);
  EXPECT_EQ(scene_from_text(head + scene_text(), "f").motion->period(), 1) << "a default is in SI";
  EXPECT_NE(refusal_of([] { scene_from_text(head + scene_text("time: {end: 1e-323}\n"), "f"); }).find("SI units"),
            std::string::npos);
}

TEST(SceneUnits, ExpectationsAreInThem) {
  const Scene scene = scene_from_text(head + scene_text("expect: {error.l2_max: {below: 65}, error.relative: {below: "
                                                        "0.1}, t: {between: [1, 2]}}\n"),
                                      "f");
  EXPECT_DOUBLE_EQ(scene.expect[0].number, 0.065);
  EXPECT_EQ(scene.expect[1].number, 0.1);
  EXPECT_DOUBLE_EQ(scene.expect[2].upper, 0.002);
  const ExpectationOutcome outcome = judged(scene.expect[0], 0.0321, author_unit("error.l2_max", mm_MPa_ms));
  EXPECT_EQ(outcome.expected, "below 65 mm");
  EXPECT_EQ(outcome.found, "32.1 mm");
  EXPECT_TRUE(outcome.holds);
}

TEST(SceneUnits, UnknownOnesAreRefused) {
  const auto line = [](const std::string& units) {
    return refusal_of([&] { scene_from_text("units: " + units + "\n" + scene_text(), "f"); });
  };
  EXPECT_EQ(line("{length: mmm}"), "f:1:17: units.length: unknown value 'mmm' (nearest: mm); known: m, mm, cm, um, in");
  EXPECT_EQ(line("{stress: N/mm2}").substr(0, 33), "f:1:17: units.stress: unknown val");
  EXPECT_EQ(line("mm"), "f:1:8: units: must be a map of keys, found 'mm'; known: length, stress, time");
  EXPECT_NE(line("{mass: t}").find("unknown key"), std::string::npos);
}

TEST(SceneUnits, OfATableOfF) {
  const ScratchFolder scratch;
  const auto read = [&](const std::string& header, const std::string& extra, const std::string& units) {
    scratch.write("F.csv", header + ",F11,F12,F21,F22\n0,1,0,0,1\n500,1.1,0,0,1\n");
    const std::string text = units + "motion: {type: homogeneous, path: F.csv" + extra +
                             "}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n";
    return scene_from_text(text, scratch / "scene.yaml");
  };
  EXPECT_EQ(read("t", "", head).motion->period(), 0.5);
  EXPECT_EQ(read("t [s]", "", head).motion->period(), 500) << "the header wins";
  EXPECT_EQ(read("t [ms]", "", "").motion->period(), 0.5);
  EXPECT_EQ(read("t", ", time_unit: min", head).motion->period(), 30000);
  const Scene scene = read("t", "", head);
  const std::string resolved = resolved_yaml(scene);
  EXPECT_NE(resolved.find("time_unit: ms\n"), std::string::npos);
  EXPECT_EQ(scene_from_text(resolved, "elsewhere.yaml").motion->period(), 0.5);
  EXPECT_NE(refusal_of([&] { read("t [MPa]", "", ""); }).find("no unit of a time"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_scene_units
