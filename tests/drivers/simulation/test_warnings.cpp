// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/warnings.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_warnings {
namespace {

std::string scene_and(const std::string& more) {
  return "motion: {type: vortex, amplitude: {peak: 0.1}}\n"
         "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
         "body: {domain: ring}\ngrid: {spacing: 0.1}\nmethod: {basis: cpdi}\n" +
         more;
}

/// One after the other.
std::string warnings_in(const std::string& scene) {
  std::string all;
  for (const std::string& sentence : warnings_of(assemble(scene_from_text(scene, "f.yaml", {}), 1))) all += sentence;
  return all;
}

TEST(Warnings, SaysThatAStepIsTooLongToBeStable) {
  EXPECT_EQ(warnings_in(scene_and("")), "");
  EXPECT_EQ(warnings_in(scene_and("time: {step: 0.01}\n")), "");
  EXPECT_NE(warnings_in(scene_and("time: {step: 0.25}\n")).find("times what the fastest wave takes to cross a cell"),
            std::string::npos);
}

TEST(Warnings, SaysThatFreeFacesDoNotBearTheStressOfRest) {
  std::string scene = scene_and("");
  const std::string model = "neo_hookean, parameters: {E: 1e3, nu: 0.3}";
  scene.replace(scene.find(model), model.size(), built("tests/plugins/pressed_at_rest.so"));
  EXPECT_EQ(warnings_in(scene),
            "the material bears 100 Pa at rest, and free faces no traction: the body will not follow the motion there");
  scene.replace(scene.find("ring"), 4, "square, outside: held");
  EXPECT_EQ(warnings_in(scene), "");
}

}  // namespace
}  // namespace assay::drivers::test_warnings
