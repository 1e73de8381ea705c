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

TEST(Warnings, SaysThatAVortexIsThinInItsGrid) {
  const auto said = [](const std::string& vortex, const std::string& spacing, const std::string& more = "") {
    const std::string scene = "motion: {type: vortex3d, " + vortex +
                              ", amplitude: {peak: 0.1}}\n"
                              "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
                              "body: {domain: vortex}\nmethod: {basis: cpdi}\ngrid: {spacing: " +
                              spacing + "}\n" + more;
    std::string all;
    for (const std::string& sentence : warnings_of(assemble<3>(scene_from_text(scene, "f.yaml", {}), 1)))
      all += sentence;
    return all;
  };
  const std::string drum = "profile: drum, height: 0.13", torus = "profile: torus, radius: 0.25, ring_radius: 1";
  EXPECT_NE(said(drum, "0.125").find("a vortex is 0.26 m thick, which is 2.1 cells: errors may be as large"),
            std::string::npos);
  EXPECT_NE(said(drum, "0.125").find("force.evaluation: domain_average"), std::string::npos);
  EXPECT_EQ(said(drum, "0.125", "force: {evaluation: domain_average}\n").find("force.evaluation"), std::string::npos);
  EXPECT_NE(said(torus, "0.2").find("0.5 m thick"), std::string::npos);
  EXPECT_EQ(said(torus, "0.125"), "");
  EXPECT_EQ(said("profile: ball", "0.25"), "");
}

TEST(Warnings, SaysThatAStepIsTooLongToBeStable) {
  EXPECT_EQ(warnings_in(scene_and("")), "");
  EXPECT_EQ(warnings_in(scene_and("time: {step: 0.01}\n")), "");
  EXPECT_NE(
      warnings_in(scene_and("time: {step: 0.25}\n")).find("times the time in which the fastest wave crosses a cell"),
      std::string::npos);
}

/// A steel in a second: errors of thousands of waves add up. In both periods that are named they do not.
TEST(Warnings, SaysThatAMotionIsVeryLongAgainstTheWaves) {
  const auto of = [](const std::string& E, const std::string& period) {
    std::string scene = scene_and("");
    scene.replace(scene.find("E: 1e3"), 6, "E: " + E);
    scene.replace(scene.find("density: 1000"), 13, "density: 7850");
    return warnings_in(scene.replace(scene.find("{type: vortex,"), 14, "{type: vortex, period: " + period + ","));
  };
  for (const char* E : {"2.1e11", "7e10", "1e13"}) {
    const std::string found = of(E, "1");
    EXPECT_NE(found.find("a wave crosses the body "), std::string::npos) << found;
    const std::string before[] = {"motion.period: ", " shortens the run, and "};
    for (const std::string& words : before) {
      const std::size_t at = found.find(words) + words.size();
      ASSERT_LT(at, found.size()) << found;
      EXPECT_EQ(of(E, found.substr(at, found.find(' ', at) - at)), "") << found;
    }
  }
  EXPECT_EQ(of("1e3", "1"), "");
  EXPECT_EQ(of("1e8", "1"), "") << "a stiff case of the stability map";
}

/// A shorter period alone would only repeat the motion more often.
TEST(Warnings, AShorterPeriodComesWithTheEndThatTheSceneGives) {
  const auto of = [](const std::string& period, const std::string& end) {
    std::string scene = scene_and("time: {end: " + end + "}\n");
    scene.replace(scene.find("E: 1e3"), 6, "E: 2.1e11");
    return warnings_in(scene.replace(scene.find("{type: vortex,"), 14, "{type: vortex, period: " + period + ","));
  };
  const std::string found = of("1", "2"), words = "motion.period: ", with = " with time.end: ";
  const std::size_t at = found.find(words) + words.size(), then = found.find(with, at);
  ASSERT_NE(then, std::string::npos) << found;
  const std::string period = found.substr(at, then - at), rest = found.substr(then + with.size());
  const std::string end = rest.substr(0, rest.find(' '));
  EXPECT_EQ(of(period, end), "");
  EXPECT_NEAR(std::stod(end) / std::stod(period), 2, 0.15) << "the same number of periods, to two digits each";
}

TEST(Warnings, SaysThatFreeFacesDoNotBearTheStressOfRest) {
  std::string scene = scene_and("");
  const std::string model = "neo_hookean, parameters: {E: 1e3, nu: 0.3}";
  scene.replace(scene.find(model), model.size(), built("tests/plugins/pressed_at_rest.so"));
  EXPECT_EQ(warnings_in(scene),
            "the material has a stress of 100 Pa at rest, which free faces cannot balance: the body will not follow "
            "the motion there");
  scene.replace(scene.find("ring"), 4, "square, outside: held");
  EXPECT_EQ(warnings_in(scene), "");
}

TEST(Warnings, SaysThatNoStepIsWrittenBehindTheEnd) {
  EXPECT_EQ(warnings_in(scene_and("output: {each_step_from: 1}\n")), "");
  EXPECT_EQ(warnings_in(scene_and("output: {each_step_from: 1.5}\n")),
            "output.each_step_from = 1.5 s lies beyond time.end = 1 s: no step is written for it");
}

TEST(Warnings, AreInTheUnitsOfTheScene) {
  const std::string units = "units: {length: mm, stress: MPa, time: ms}\n";
  std::string scene =
      "motion: {type: vortex, amplitude: {peak: 0.1}}\n"
      "material: {adapter: neo_hookean, parameters: {E: 1e-3, nu: 0.3}, density: 1e-3}\n"
      "body: {domain: ring}\ngrid: {spacing: 100}\nmethod: {basis: cpdi}\n";
  EXPECT_EQ(warnings_in(units + scene + "output: {each_step_from: 1500}\n"),
            "output.each_step_from = 1500 ms lies beyond time.end = 1000 ms: no step is written for it");
  EXPECT_EQ(warnings_in(units + scene + "time: {step: 250}\n").find("time.step = 250 ms is "), 0u)
      << warnings_in(units + scene + "time: {step: 250}\n");
  const std::string model = "neo_hookean, parameters: {E: 1e-3, nu: 0.3}";
  scene.replace(scene.find(model), model.size(), built("tests/plugins/pressed_at_rest.so"));
  EXPECT_EQ(warnings_in(units + scene).find("the material has a stress of 0.0001 MPa at rest"), 0u)
      << warnings_in(units + scene);
}

TEST(Warnings, SaysThatADensityIsThatOfOtherUnits) {
  const auto of = [](const char* density, const char* E) {
    std::string scene = scene_and("time: {end: 1.0e-9, step: 1.0e-12}\n");
    scene.replace(scene.find("density: 1000"), 13, std::string("density: ") + density);
    return warnings_in(scene.replace(scene.find("E: 1e3"), 6, std::string("E: ") + E));
  };
  EXPECT_EQ(of("7850", "2.1e11"), "");
  EXPECT_EQ(of("0.2", "1e6"), "") << "an aerogel";
  EXPECT_EQ(of("7.85e-9", "2.1e5"), "") << "of one system: t, mm, s and MPa";
  const std::string mixed = of("7.85e-9", "2.1e11");
  EXPECT_NE(mixed.find("in t/mm^3 the density would be 7850 kg/m^3"), std::string::npos) << mixed;
}

TEST(Warnings, SaysThatNoCellIsFilled) {
  const auto of = [](const char* spacing) {
    return warnings_in(
        "motion: {type: homogeneous, final: [[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n"
        "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
        "body: {domain: box, lower: [0, 0], upper: [1, 0.5]}\nmethod: {basis: linear}\n"
        "grid: {spacing: " +
        std::string(spacing) + "}\n");
  };
  EXPECT_EQ(of("0.5"), "");
  EXPECT_NE(of("1").find("is larger than the body, which is 0.5 m across"), std::string::npos) << of("1");
}

TEST(Warnings, SaysThatAFacePullsAtTheEndOfASpline) {
  const auto of = [](const std::string& method, const std::string& per_cell, const std::string& ends = "") {
    return warnings_in(
        "motion: {type: homogeneous, final: [[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]}\n"
        "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
        "body: {domain: box, lower: [0, 0], upper: [1, 0.5], per_cell: " +
        per_cell + "}\ngrid: {spacing: 0.125}\nmethod: {basis: " + method + "}\n" + ends);
  };
  const std::string total = "bspline2, transfer: apic, formulation: total";
  for (const char* odd : {"[1, 2]", "[1, 1]", "[1, 4]"}) {
    EXPECT_NE(of(total, odd).find("outermost particles along X"), std::string::npos) << of(total, odd);
    EXPECT_EQ(of("bspline3, transfer: apic, formulation: total", odd), "");
    EXPECT_EQ(of("bspline2, transfer: apic", odd), "");
    EXPECT_EQ(of(total, odd, "traction: {algorithm: virtual_stress}\n"), "");
  }
  EXPECT_NE(of(total, "[2, 1]").find("outermost particles along Y"), std::string::npos);
  EXPECT_EQ(of(total, "[2, 2]"), "");
  EXPECT_EQ(of(total, "[3, 3]"), "") << "the outermost lie a sixth of a cell from the face";
}

}  // namespace
}  // namespace assay::drivers::test_warnings
