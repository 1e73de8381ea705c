// SPDX-License-Identifier: BSD-3-Clause
// Scenes of the vortex in three dimensions: what is read, what is refused, and what is written back.
#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers::test_vortex3d_scenes {
namespace {

const std::string elastic = "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";

Scene scene(const std::string& motion, const std::string& material = elastic) {
  return scene_from_text("motion:\n  type: vortex3d\n" + motion + material, "v.yaml", {}, Interpolation::linear);
}

const Vortex3d& vortex(const Scene& scene) { return *scene.motion.as<Vortex3d>(); }

std::string refusal(const std::string& motion, const std::string& material = elastic) {
  try {
    Scene read = scene(motion, material);
    std::string library;
    material_of(read, library);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_refused(const std::string& motion, const std::string& part, const std::string& material = elastic) {
  const std::string found = refusal(motion, material);
  EXPECT_NE(found.find(part), found.npos) << found;
}

TEST(Vortex3dScenes, HaveDefaultsOfABall) {
  const Scene read = scene("");
  EXPECT_EQ(read.dimension, 3);
  const Revolution& one = vortex(read).one;
  EXPECT_EQ(one.profile, Revolution::Profile::ball);
  EXPECT_EQ(one.radius, 1);
  EXPECT_EQ(one.profile_power, 4);
  EXPECT_EQ(one.axis, Vector3::UnitZ());
  EXPECT_EQ(one.center, Vector3::Zero());
}

TEST(Vortex3dScenes, ReadTheKeysOfEachProfile) {
  const Revolution torus = vortex(scene("  profile: torus\n  ring_radius: 0.6\n  radius: 0.35\n  profile_power: 2\n"
                                        "  axis: [1, 2, 3]\n  center: [0.1, 0.2, 0.3]\n  strength: -0.5\n"))
                               .one;
  EXPECT_EQ(torus.profile, Revolution::Profile::torus);
  EXPECT_EQ(torus.ring_radius, 0.6);
  EXPECT_EQ(torus.radius, 0.35);
  EXPECT_EQ(torus.profile_power, 2);
  EXPECT_EQ(torus.axis, Vector3(1, 2, 3));
  EXPECT_EQ(torus.center, Vector3(0.1, 0.2, 0.3));
  EXPECT_EQ(torus.strength, -0.5);
  const Revolution drum = vortex(scene("  profile: drum\n  radius: 0.8\n  height: 0.3\n  height_power: 3\n")).one;
  EXPECT_EQ(drum.height, 0.3);
  EXPECT_EQ(drum.height_power, 3);
}

const std::string two =
    "  vortices:\n"
    "    - {profile: ball, radius: 0.4, center: [0.5, 0, 0], axis: [1, 2, 3]}\n"
    "    - {profile: torus, ring_radius: 0.3, radius: 0.1, center: [-0.5, 0, 0], strength: -0.5}\n";

TEST(Vortex3dScenes, ReadSeveralVorticesAndWriteThemBack) {
  const Scene read = scene(two);
  ASSERT_EQ(vortex(read).vortices.size(), 2U);
  EXPECT_EQ(vortex(read).vortices[0].axis, Vector3(1, 2, 3));
  EXPECT_EQ(vortex(read).vortices[1].ring_radius, 0.3);
  EXPECT_EQ(vortex(read).vortices[1].strength, -0.5);
  const std::string text = resolved_yaml(read);
  const Scene again = scene_from_text(text, "resolved.yaml", {}, Interpolation::linear);
  EXPECT_EQ(resolved_yaml(again), text);
  EXPECT_EQ(vortex(again).vortices[0].center, Vector3(0.5, 0, 0));
}

TEST(Vortex3dScenes, OfOneVortexReadBackToo) {
  for (const std::string motion : {"", "  profile: torus\n  ring_radius: 0.6\n  radius: 0.35\n",
                                   "  profile: drum\n  radius: 0.8\n  height: 0.3\n"}) {
    const std::string text = resolved_yaml(scene(motion));
    EXPECT_EQ(resolved_yaml(scene_from_text(text, "resolved.yaml", {}, Interpolation::linear)), text) << motion;
  }
}

TEST(Vortex3dScenes, WhatDoesNotBelongToTheProfileIsRefused) {
  expect_refused("  ring_radius: 0.5\n", "motion.ring_radius: belongs to a torus, and profile is ball");
  expect_refused("  height: 0.5\n", "motion.height: belongs to a drum, and profile is ball");
  expect_refused("  profile: torus\n", "motion.ring_radius: required of a torus and not given");
  expect_refused("  profile: drum\n", "motion.height: required of a drum and not given");
  expect_refused("  profile: torus\n  ring_radius: 0.2\n  radius: 0.3\n", "must be more than radius");
  expect_refused("  profile: cube\n", "unknown value 'cube'; known: ball, torus, drum");
  expect_refused("  axis: [0, 0, 0]\n", "motion.axis: must not be zero");
  expect_refused("  profile_power: 1\n", "motion.profile_power: must be from 2 to 64, found '1'");
  expect_refused("  inner: 0.5\n", "does not belong to motion.type vortex3d");
  expect_refused("  amplitude: {type: travelling}\n", "unknown value 'travelling'");
}

TEST(Vortex3dScenes, FaultsOfAVortexInTheListSayWhich) {
  expect_refused("  vortices:\n    - {radius: 0.4}\n    - {profile: torus, center: [2, 0, 0]}\n",
                 "motion.vortices[1].ring_radius: required of a torus");
  expect_refused("  vortices:\n    - {radius: 0.4}\n    - {radius: 0.4, height: 1, center: [2, 0, 0]}\n",
                 "v.yaml:5:29: motion.vortices[1].height: belongs to a drum");
  expect_refused("  vortices:\n    - {radius: 0.4}\n    - {radius: 0.4, center: [0.7, 0, 0]}\n",
                 "motion.vortices[1]: overlaps motion.vortices[0]");
  expect_refused("  radius: 1\n" + two, "motion.radius: belongs to the items of motion.vortices, which is given");
  expect_refused("  vortices: []\n", "found an empty list");
}

TEST(Vortex3dScenes, OneThatIsPlaneIsRefused) {
  expect_refused("", "dimension: must be 3 for motion.type vortex3d", "dimension: 2\n" + elastic);
}

TEST(Vortex3dScenes, AModelWithAxesOfItsOwnIsRefused) {
  expect_refused(
      "  amplitude: {peak: 0.1}\n", "not isotropic",
      "material: {adapter: orthotropic_cylindrical, density: 1000, parameters: {E_r: 1000, E_t: 1500, E_z: 700, "
      "nu_rt: 0.2, nu_rz: 0.25, nu_tz: 0.3, G_rt: 350, G_rz: 300, G_tz: 400}}\n");
}

/// Whatever the amplitude, an isotropic model is one: neither rounding nor a stress without bounds is compared.
TEST(Vortex3dScenes, AnIsotropicModelIsTakenAtAnyAmplitude) {
  const std::string mooney =
      "material: {adapter: mooney_rivlin, parameters: {c10: 120, c01: 60, bulk_modulus: 900}, density: 1000}\n";
  for (const std::string motion :
       {"  amplitude: {peak: 0}\n", "  amplitude: {peak: 1.0e-30}\n", "  amplitude: {peak: 1.0e+6}\n",
        "  strength: 0\n", "  strength: 1.0e-150\n", "  profile: torus\n  ring_radius: 50\n  radius: 0.01\n"}) {
    EXPECT_EQ(refusal(motion, mooney), "accepted") << motion;
    EXPECT_EQ(refusal(motion), "accepted") << motion;
  }
  EXPECT_EQ(refusal("",
                    "material: {adapter: compressible_fluid, parameters: {bulk_modulus: 1000, viscosity: 0}, "
                    "density: 1000}\n"),
            "accepted");
}

TEST(Vortex3dScenes, SizesWhosePowersAreNoNumbersAreRefused) {
  expect_refused("  radius: 1.0e-200\n", "motion.radius: must be from 1e-50 to 1e+50");
  expect_refused("  profile: torus\n  ring_radius: 1.0e+200\n", "motion.ring_radius: must be from 1e-50 to 1e+50");
  expect_refused("  profile: drum\n  height: 1.0e-100\n", "motion.height: must be from 1e-50 to 1e+50");
}

}  // namespace
}  // namespace assay::drivers::test_vortex3d_scenes
