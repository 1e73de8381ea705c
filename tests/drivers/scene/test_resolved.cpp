// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <random>

#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/text/numbers.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/mpm/effect_keys.hpp"
#include "tests/support/kept_yaml.hpp"

namespace assay::drivers::test_resolved {
namespace {

void expect_same(const Scene& a, const Scene& b, const std::string& what) {
  EXPECT_EQ(a.motion->type(), b.motion->type()) << what;
  for (const Key& key : scene_keys()) {
    ASSERT_EQ(applies(key, a), applies(key, b)) << what << " " << key.path;
    if (applies(key, a)) {
      EXPECT_EQ(key.get(a), key.get(b)) << what << " " << key.path;
    }
  }
  EXPECT_EQ(a.grid.has_value(), b.grid.has_value()) << what;
  EXPECT_EQ(a.method.has_value(), b.method.has_value()) << what;
  EXPECT_EQ(a.material.parameters, b.material.parameters) << what;
  ASSERT_EQ(a.expect.size(), b.expect.size()) << what;
  for (std::size_t i = 0; i < a.expect.size(); ++i) {
    EXPECT_EQ(a.expect[i].key, b.expect[i].key);
    EXPECT_EQ(expectation_yaml(a.expect[i]), expectation_yaml(b.expect[i])) << what;
  }
}

/// Reading it back from elsewhere gives the same scene and the same text; it is kept for other readers.
void check_round_trip(const Scene& scene, const std::string& what) {
  const std::string once = resolved_yaml(scene);
  keep_yaml("scene", once);
  const Scene again = scene_from_text(once, "/elsewhere/resolved.yaml");
  expect_same(scene, again, what);
  EXPECT_EQ(resolved_yaml(again), once) << what;
}

TEST(Resolved, EveryShippedSceneReadsBack) {
  for (const std::string& file : all_configs()) check_round_trip(read_scene(file), file);
}

TEST(Resolved, SettingsReadBack) {
  const std::vector<std::string> settings{"title='a: \"b\" # c'",
                                          "title=\"quote ' back \\\\ slash \xc3\xa9\"",
                                          "title='1e3'",
                                          "title=~x",
                                          "motion.amplitude.peak=-0",
                                          "motion.amplitude={type: one_minus_cosine, peak: 0.1}",
                                          "motion.allow_unstable=true",
                                          "time={end: 0.3, step: 1e-3}",
                                          "body={domain: square}",
                                          "body={lattice: jittered, jitter: 0.125, seed: 12}",
                                          "body={domain: box, lower: [-2, -3], upper: [2, 3.5], outside: free}",
                                          "grid={spacing: 0.1, lower: [-2, -2], upper: [2, 2]}",
                                          "material.adapter=lib.so:x",
                                          "material.adapter='my lib.so'",
                                          "material.parameters={'a b': 1, '1': 2, 'null': 3}",
                                          "expect={reason: 'x: y', t: {between: [0.1, 0.2]}}",
                                          "expect={uses_exact_solution: false, sheet.cached: {equals: true}}",
                                          "expect.uses_exact_solution=false",
                                          "expect.sheet.cached.equals=true",
                                          "method={basis: linear}",
                                          "frame={angle: 0.7, spin: 1.3, velocity: [0.4, -0.2]}",
                                          "frame.angle=-1e-3",
                                          "limits.particle_steps=1e300",
                                          "material.density=4.9406564584124654e-300",
                                          "output={pictures: false, particles: 0}",
                                          "force={response: none}"};
  for (const std::string& setting : settings) {
    check_round_trip(scene_from_text(scene_text("grid: {spacing: 0.1}\n"), "/a/f.yaml", {setting}), setting);
  }
  check_round_trip(scene_from_text(homogeneous_text("body: {domain: box}\n"), "/a/f.yaml"), "homogeneous");
  const std::string space = "dimension: 3\nframe: {spin: 1, axis: [1, 2, 3], velocity: [1, 2, 3]}\n";
  check_round_trip(scene_from_text(homogeneous_text(space), "/a/f.yaml"), "in space");
  const std::string box =
      "motion: {type: axis_aligned, wave_speed: 1}\nmaterial: {adapter: neo_hookean, density: 1000}\ndimension: 3\n";
  for (const char* setting : {"time.end=1", "motion.factors=[1, -1, 0]", "motion.factors=[2, 1, -0.3]"}) {
    check_round_trip(scene_from_text(box, "/a/f.yaml", {setting}), setting);
  }
}

TEST(Resolved, SaysTheDimensionWhereItIsNotThePlane) {
  EXPECT_EQ(resolved_yaml(scene_from_text(scene_text(), "f")).find("dimension"), std::string::npos);
  EXPECT_TRUE(resolved_yaml(scene_from_text("dimension: 3\n" + scene_text(), "f")).find("dimension: 3\n") !=
              std::string::npos);
}

TEST(Resolved, RandomNumbersReadBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.1, 1), any(-1e3, 1e3);
  for (int i = 0; i < 200; ++i) {
    const double inner = radius(random);
    const std::vector<std::string> sets{
        "motion.inner=" + number_text(inner), "motion.outer=" + number_text(inner + radius(random)),
        "motion.amplitude.peak=" + number_text(any(random)), "material.parameters.E=" + number_text(any(random)),
        "time={end: " + number_text(radius(random)) + "}"};
    check_round_trip(scene_from_text(scene_text(), "/a/f.yaml", sets), sets[0]);
  }
}

TEST(Resolved, HoldsEveryKeyThatApplies) {
  Scene scene = scene_from_text(
      scene_text("grid: {spacing: .1, lower: [-2, -2], upper: [2, 2]}\nmethod: {basis: ugimp, transfer: "
                 "aflip, mass: series}\nbody: {lattice: jittered}\ntime: {step: .1}\nframe: {}\n"),
      "f");
  scene.material.direction = {0.0, 1.0, 0.0};                             // of a model that has one
  scene.material.initial_stress = {-1.0, -1.0, -1.0, 0.0, 0.0, 0.0};      // none by default
  scene.material.isolation = Isolation::none;                             // filled in with the material
  scene.body.initial_velocity.emplace();                                  // of a scene without a force
  EXPECT_TRUE(mpm::tell(scene.effects, "remedies.largest_domain", 1.0));  // of cpdi
  EXPECT_TRUE(mpm::tell(scene.effects, "remedies.small_mass", 0.1));      // of lumped mass
  EXPECT_TRUE(mpm::tell(scene.effects, "remedies.artificial_viscosity", std::vector{0.1, 1.5}));
  scene.output.each_step_from = 0.9;
  scene.dimension = 3, scene.frame->axis = {1, 2, 3};  // told where they are not those of the plane
  const std::string text = resolved_yaml(scene);
  const Tree root = read_yaml(text, "resolved");
  for (const Key& key : scene_keys()) {
    if (key.path.starts_with("units.")) continue;  // what is written in full is in SI
    const Tree* at = &root;
    std::string path = key.path;
    for (std::size_t dot; at && (dot = path.find('.')) != path.npos; path.erase(0, dot + 1))
      at = at->find(path.substr(0, dot));
    EXPECT_EQ(at && at->find(path), applies(key, scene)) << key.path << "\n" << text;
  }
}

TEST(Resolved, IsAFunctionOfTheValuesAlone) {
  const Scene a = scene_from_text(scene_text(), "/a/x.yaml");
  const Scene b = scene_from_text(
      "# remark\nmaterial: {density: 1.0e+3, parameters: {E: 1000.0}, adapter: 'neo_hookean'}\n"
      "motion:\n  type: vortex\n  inner: .75\n",
      "/b/y.yaml");
  EXPECT_EQ(resolved_yaml(a), resolved_yaml(b));
}

}  // namespace
}  // namespace assay::drivers::test_resolved
