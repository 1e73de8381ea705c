// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_choice.hpp"

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"

namespace assay::drivers::test_material_choice {
namespace {

class MaterialChoices : public RegistryTest {
 protected:
  static Scene scene(const std::string& material, const std::string& motion = "{type: vortex}") {
    return scene_from_text("motion: " + motion + "\nmaterial: " + material + "\n", "f.yaml");
  }
  static std::string refused(const std::string& material, const std::string& motion = "{type: vortex}") {
    return refusal_of([&] { resolve_material(scene(material, motion)); });
  }
};

TEST_F(MaterialChoices, FillsDefaultsIn) {
  const ResolvedMaterial found = resolve_material(scene("{adapter: neo_hookean, parameters: {E: 5}, density: 2}"));
  EXPECT_EQ(found.choice.parameters, (std::map<std::string, double>{{"E", 5}, {"nu", 0.3}}));
  EXPECT_EQ(found.material.parameter("nu"), 0.3);
  EXPECT_EQ(found.library, "");
}

TEST_F(MaterialChoices, TheSceneGoesBeforeTheDescription) {
  const std::string file = write("d.yaml", "library: " + plugins +
                                               "two_models.so\nname: first\n"
                                               "parameters: {modulus: 5}\ndensity: 7\n");
  EXPECT_EQ(resolve_material(scene("{adapter: " + file + "}")).choice.density, 7);
  EXPECT_EQ(resolve_material(scene("{adapter: " + file + "}")).choice.parameters.at("modulus"), 5);
  const ResolvedMaterial own = resolve_material(scene("{adapter: " + file + ", parameters: {modulus: 6}, density: 8}"));
  EXPECT_EQ(own.choice.parameters.at("modulus"), 6);
  EXPECT_EQ(own.choice.density, 8);
  EXPECT_EQ(own.library, plugins + "two_models.so");

  Scene whole = scene("{adapter: " + file + "}");
  whole.material = resolve_material(whole).choice;
  const Scene again = scene_from_text(resolved_yaml(whole), "/elsewhere/resolved.yaml");
  EXPECT_EQ(resolve_material(again).choice.parameters, whole.material.parameters);
}

TEST_F(MaterialChoices, RefusesWithThePlaceOfTheParameter) {
  EXPECT_EQ(
      refused("{adapter: neo_hookean, density: 1}"),
      "f.yaml:2:21: material.parameters.E: required by material 'neo_hookean' and not given; must lie from 1e-300 to "
      "1e+300 [Pa]");
  EXPECT_EQ(
      refused("{adapter: neo_hookean, parameters: {E: 1, mu: 2}, density: 1}"),
      "f.yaml:2:53: material.parameters.mu: material 'neo_hookean' has no such parameter (nearest: nu); known: E, nu");
  EXPECT_TRUE(refused("{adapter: neo_hookean, parameters: {shear_modulus: 2}, density: 1}")
                  .ends_with("material 'neo_hookean' has no such parameter; known: E, nu"));
  EXPECT_TRUE(refused("{adapter: neo_hookean, parameters: {E: -1}, density: 1}")
                  .starts_with("f.yaml:2:50: material.parameters.E: must lie from 1e-300 to 1e+300 [Pa], found -1"));
  const std::string file =
      write("d.yaml", "library: " + plugins + "two_models.so\nname: first\nparameters: {modulus: -5}\n");
  EXPECT_TRUE(refused("{adapter: " + file + ", density: 1}")
                  .starts_with(file + ":3:23: material.parameters.modulus: must lie"));
  EXPECT_TRUE(refused("{adapter: " + plugins + "refuses.so, density: 1}").ends_with("no licence for this model"));
}

TEST_F(MaterialChoices, RefusesTheRestToo) {
  EXPECT_EQ(refused("{adapter: neo_hookean, parameters: {E: 1}}"),
            "f.yaml:2:21: material.density: required: neither the scene nor the material gives one");
  EXPECT_TRUE(refused("{adapter: nobody, density: 1}").starts_with("f.yaml:2:21: material.adapter: unknown material"));
  const std::string fibres = "{adapter: " + plugins + "anisotropic.so, parameters: {modulus: 1}, density: 1}";
  EXPECT_NE(refused(fibres).find("'anisotropic' is anisotropic in fixed axes"), std::string::npos);
  EXPECT_EQ(refused(fibres, "{type: homogeneous, final: [[1.1,0,0],[0,1,0],[0,0,1]]}"), "accepted");
}

const std::string ring_wood =
    "adapter: orthotropic_cylindrical, density: 1, parameters: {E_r: 3e3, E_t: 1e3, E_z: 2e3, nu_rt: 0.3, nu_rz: 0.2, "
    "nu_tz: 0.25, G_rt: 700, G_rz: 500, G_tz: 400}";

TEST_F(MaterialChoices, ADirectionBelongsToModelsThatHaveOne) {
  Scene wood = scene("{" + ring_wood + "}");
  wood.material = resolve_material(wood).choice;
  EXPECT_EQ(wood.material.direction, (std::array{1.0, 0.0, 0.0}));  // E_R
  EXPECT_NE(resolved_yaml(wood).find("direction: [1, 0, 0]"), std::string::npos);
  Scene inclined = scene("{" + ring_wood + ", direction: [3, 4, 0]}");
  inclined.material = resolve_material(inclined).choice;
  const auto unit = baseline_path(inclined).material_direction;
  EXPECT_DOUBLE_EQ(unit[0], 0.6);
  EXPECT_DOUBLE_EQ(unit[1], 0.8);
  EXPECT_EQ(unit[2], 0);
  const Scene again = scene_from_text(resolved_yaml(inclined), "resolved.yaml");
  EXPECT_EQ(again.material.direction, (std::array{3.0, 4.0, 0.0}));

  EXPECT_EQ(refused("{adapter: neo_hookean, parameters: {E: 1}, density: 1, direction: [0, 1, 0]}"),
            "f.yaml:2:77: material.direction: 'neo_hookean' has no direction");
  EXPECT_EQ(refused("{" + ring_wood + ", direction: [0, 0, 0]}"),
            "f.yaml:2:" + std::to_string(std::string("material: {" + ring_wood + ", direction: ").size() + 1) +
                ": material.direction: must not be zero");
  EXPECT_NE(refused("{" + ring_wood + ", direction: [1, 0]}").find("material.direction: "), std::string::npos);
  Scene plain = scene("{adapter: neo_hookean, parameters: {E: 1}, density: 1}");
  plain.material = resolve_material(plain).choice;
  EXPECT_EQ(resolved_yaml(plain).find("direction"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_material_choice
