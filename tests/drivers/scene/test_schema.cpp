// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "drivers/result/result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_file.hpp"
#include "tests/drivers/json_schema.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scene_text.hpp"

namespace assay::drivers::test_schema {
namespace {

using nlohmann::json;

const json& the_schema() {
  static const json schema = json::parse(schema_json());
  return schema;
}

bool accepts(const std::string& yaml) { return valid(the_schema(), json_of(read_yaml(yaml, "f"))); }

void collect(const json& schema, const std::string& path, std::set<std::string>& leaves) {
  for (const json& one : schema.value("oneOf", json::array())) collect(one, path, leaves);
  if (!schema.contains("properties")) return;
  for (const auto& [name, member] : schema["properties"].items()) {
    const std::string inside = path.empty() ? name : path + "." + name;
    if (inside == "expect" || inside == "material.parameters") continue;
    const bool branch = member.contains("properties") || inside == "motion";
    if (branch) {
      collect(member, inside, leaves);
    } else {
      leaves.insert(inside);
    }
  }
}

TEST(Schema, SaysWhatItIs) {
  EXPECT_EQ(the_schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(the_schema()["$id"], "urn:assay:schema:scene:" + build_information().version);
  EXPECT_EQ(schema_json(), schema_json());
}

TEST(Schema, ListsExactlyTheKeysOfTheReader) {
  std::set<std::string> listed, known;
  collect(the_schema(), "", listed);
  for (const Key& key : scene_keys()) known.insert(key.path);
  EXPECT_EQ(listed, known);
  std::set<std::string> figures, expected{order_key, last_order_key};
  for (const auto& [name, ignored] : the_schema()["properties"]["expect"]["properties"].items()) figures.insert(name);
  for (const std::string& key : flat_keys()) expected.insert(key);
  EXPECT_EQ(figures, expected);
}

TEST(Schema, AcceptsEveryShippedSceneAndItsResolvedForm) {
  for (const std::string& file : all_configs()) {
    EXPECT_TRUE(accepts(read_bytes(file))) << file;
    EXPECT_TRUE(accepts(resolved_yaml(read_scene(file)))) << file;
  }
  EXPECT_TRUE(accepts(homogeneous_text("body: {domain: box}")));
}

TEST(Schema, DefaultsAreWhatTheReaderFillsIn) {
  const Scene scene = scene_from_text(scene_text("grid: {spacing: 1}\nmethod: {}\n"), "f");
  const json resolved = json_of(read_yaml(resolved_yaml(scene), "resolved"));
  int compared = 0;
  for (const Key& key : scene_keys()) {
    json schema = the_schema(), value = resolved;
    bool both = true;
    std::string path = key.path + ".";
    for (std::size_t dot; both && (dot = path.find('.')) != path.npos; path.erase(0, dot + 1)) {
      const std::string name = path.substr(0, dot);
      if (schema.contains("oneOf")) schema = schema["oneOf"][0];  // the vortex
      both = schema["properties"].contains(name) && value.contains(name);
      if (both) schema = json(schema["properties"][name]), value = json(value[name]);
    }
    if (!both || !schema.contains("default")) continue;
    EXPECT_EQ(schema["default"], value) << key.path;
    ++compared;
  }
  EXPECT_GT(compared, 25);
}

TEST(Schema, SaysWhatMayBeExpected) {
  const json& figures = the_schema()["properties"]["expect"]["properties"];
  EXPECT_EQ(figures["error.l2_max"]["description"], "largest L2 error of the displacement, over the samples [m]");
  EXPECT_EQ(figures["steps"]["description"], "number of steps");
  EXPECT_TRUE(accepts(scene_text("expect: {uses_exact_solution: false, sheet.cached: {equals: true}, steps: 3}")));
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
  const std::vector<std::string> bad{"grid: {spacing: -1}",
                                     "grid: {spacing: 0}",
                                     "grid: {h: 1}",
                                     "grd: {spacing: 1}",
                                     "body: {per_cell: [2, 17]}",
                                     "body: {per_cell: [2]}",
                                     "body: {per_cell: [2, 2.5]}",
                                     "method: {basis: cpdi3}",
                                     "time: {end: soon}",
                                     "output: {pictures: 1}",
                                     "expect: {error.l2: {below: 1}}",
                                     "expect: {t: {belw: 1}}",
                                     "expect: {outcome: done}",
                                     "expect: {uses_exact_solution: 0}",
                                     "expect: {uses_exact_solution: {equals: 0}}",
                                     "expect: {sheet.cached: {below: 1}}",
                                     "expect: {sheet.cached: never}",
                                     "expect: {t: {below: 1, above: 2}}",
                                     "force: {tolerance: 1}"};
  EXPECT_TRUE(accepts(scene_text()));
  for (const std::string& extra : bad) {
    EXPECT_FALSE(accepts(scene_text(extra))) << extra;
    EXPECT_NE(refusal_of([&] { scene_from_text(scene_text(extra), "f"); }), "accepted") << extra;
  }
  EXPECT_FALSE(accepts("motion: {type: vortex}\n"));
  EXPECT_FALSE(accepts("motion: {type: vortex, profile_power: 1}\nmaterial: {adapter: x}\n"));
  EXPECT_FALSE(accepts("motion: {type: vortex, final: [[1,0,0],[0,1,0],[0,0,1]]}\nmaterial: {adapter: x}\n"));
}

}  // namespace
}  // namespace assay::drivers::test_schema
