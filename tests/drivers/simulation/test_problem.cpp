// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/problem.hpp"

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_problem {
namespace {

std::string refused_model(const std::string& material) {
  const std::string text = "motion: {type: vortex, amplitude: {peak: 0.1}}\nmaterial: " + material +
                           "\nbody: {domain: ring}\ngrid: {spacing: 0.1}\n"
                           "method: {basis: bspline2, formulation: total, integrator: symplectic_rkn4}\n";
  return refusal_of([&] { assemble(scene_from_text(text, "f.yaml", {}), 1); });
}

// A table of what each built-in model is: a step of stages goes back in time.
TEST(Problem, StagesTakeModelsWhoseStressFollowsFromF) {
  for (const char* good : {"{adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}",
                           "{adapter: saint_venant_kirchhoff, parameters: {E: 1e3, nu: 0.3}, density: 1000}",
                           "{adapter: hypoelastic_logarithmic, parameters: {E: 1e3, nu: 0.3}, density: 1000}"}) {
    EXPECT_EQ(refused_model(good), "accepted");
  }
  for (const char* bad : {"{adapter: hypoelastic_jaumann, parameters: {E: 1e3, nu: 0.3}, density: 1000}",
                          "{adapter: zener, parameters: {E: 1e3, nu: 0.3, relaxation_time: 0.5}, density: 1000}"}) {
    const std::string said = refused_model(bad);
    EXPECT_EQ(said.find("f.yaml:5:"), 0u) << said;
    EXPECT_NE(said.find("method.integrator: symplectic_rkn4 goes back in time"), std::string::npos) << said;
    EXPECT_NE(said.find("known: symplectic_euler, leapfrog"), std::string::npos) << said;
  }
}

std::string scene_with(const std::string& more) {
  return "motion: {type: vortex, amplitude: {peak: 0.1}}\n"
         "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
         "body: {domain: ring}\ngrid: {spacing: 0.1}\nmethod: {basis: cpdi}\n" +
         more;
}

TEST(Problem, CountsTheHistoriesOfAShadow) {
  const auto said = [](const std::string& more) {
    return refusal_of([&] { assemble(scene_from_text(scene_with(more), "f.yaml", {}), 1); });
  };
  const std::string many = "force: {response: shadow, radii: 1000000}\n";
  EXPECT_EQ(said("force: {response: shadow}\nlimits: {particle_steps: 1e6}\n"), "accepted");
  EXPECT_NE(said(many + "limits: {particle_steps: 1e6}\n").find("limits.particle_steps"), std::string::npos);
  EXPECT_EQ(said(many), "accepted");
  EXPECT_NE(said(many + "limits: {memory_gib: 0.1}\n").find("limits.memory_gib"), std::string::npos);
}

/// Each reversal is a stop of a history.
TEST(Problem, RefusesHistoriesOfTooManyPeriods) {
  const auto said = [](const std::string& material, const std::string& period) {
    const std::string text = "motion: {type: vortex, amplitude: {peak: 0.1}, period: " + period + "}\nmaterial: {" +
                             material +
                             ", density: 1000}\nbody: {domain: ring}\ngrid: {spacing: 0.1}\nmethod: {basis: cpdi}\n"
                             "force: {response: shadow}\ntime: {step: 0.1, end: 1}\n";
    return refusal_of([&] { assemble(scene_from_text(text, "f.yaml", {}), 1); });
  };
  const std::string viscous = "adapter: zener, parameters: {E: 1e3, relaxation_time: 1}";
  EXPECT_EQ(said(viscous, "1e-3"), "accepted");
  for (const char* period : {"1e-7", "1e-100", "5e-324"})
    EXPECT_NE(said(viscous, period).find("time.end: histories are followed over at most 10000 periods"),
              std::string::npos)
        << period;
}

TEST(Problem, CountsTheHistoriesUnderASheet) {
  const auto said = [](const std::string& model, const std::string& end) {
    const std::string text = "motion: {type: vortex, amplitude: {peak: 0.1}}\n" + model +
                             ", density: 1000}\nbody: {domain: ring}\n" +
                             "grid: {spacing: 0.1}\nmethod: {basis: cpdi}\ntime: {step: 0.1, end: " + end + "}\n" +
                             "limits: {particle_steps: 1e6}\n";
    return refusal_of([&] { assemble(scene_from_text(text, "f.yaml", {}), 1); });
  };
  const std::string elastic = "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}";
  const std::string plastic = "material: {adapter: j2_jaumann, parameters: {E: 1e3, nu: 0.3, yield_stress: 20}";
  EXPECT_EQ(said(plastic, "1"), "accepted");
  EXPECT_NE(said(plastic, "30").find("those of the response's histories included"), std::string::npos);
  EXPECT_EQ(said(elastic, "30"), "accepted");  // a curve
}

TEST(Problem, RefusesAWaveThatNoNumberHolds) {
  const auto said = [](const std::string& density) {
    return refusal_of([&] {
      assemble(
          scene_from_text("motion: {type: bar_1d}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e300, nu: 0}, "
                          "density: " +
                              density + "}\ngrid: {spacing: 0.25}\nmethod: {basis: linear}\n",
                          "f.yaml", {}),
          1);
    });
  };
  EXPECT_NE(said("1e-320").find("motion.wave_speed: auto takes sqrt(E/rho0), which is inf m/s"), std::string::npos);
  EXPECT_EQ(said("1e300"), "accepted");
}

/// The step is given: no number of steps tells it.
TEST(LongProblem, RefusesSpeedsThatNoNumberHolds) {
  const std::string said = refusal_of([] {
    assemble(scene_from_text("motion: {type: bar_1d, wave_speed: 1e300}\n"
                             "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0}, density: 1}\n"
                             "grid: {spacing: 0.25}\nmethod: {basis: linear}\ntime: {end: 1, step: 0.1}\n",
                             "f.yaml", {}),
             1);
  });
  EXPECT_NE(said.find("motion: is faster than numbers go: fastest wave"), std::string::npos) << said;
}

/// What is fast is blamed, whichever key it stands under.
TEST(Problem, BlamesTheFrameForItsOwnSpeed) {
  for (const std::string& frame : {std::string("{spin: 1e308}"), std::string("{spin: -1e20, angle: 1}")}) {
    const std::string said = refusal_of([&] {
      assemble(scene_from_text("motion: {type: vortex, amplitude: {type: sine, peak: 0.5}}\n"
                               "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0}, density: 1}\n"
                               "grid: {spacing: 0.25}\nmethod: {basis: linear}\nframe: " +
                                   frame + "\n",
                               "f.yaml", {}),
               1);
    });
    EXPECT_NE(said.find("f.yaml:5:8: frame: gives "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_problem
