// SPDX-License-Identifier: BSD-3-Clause
// Steps as long as the particles allow: they follow what waves there are, meet T/2 and the end, and are refused where
// they are fixed.
#include "drivers/simulation/time_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers {
namespace {

std::string controlled_scene(const std::string& method, const std::string& time = "{control: current}",
                             const std::string& model = "neo_hookean, parameters: {E: 1e3, nu: 0.3}") {
  return "motion: {type: vortex, amplitude: {peak: 1}}\nmaterial: {adapter: " + model +
         ", density: 1000}\nbody: {domain: ring}\ngrid: {spacing: 0.125}\nmethod: " + method +
         "\nforce: {response: closed_form}\ntime: " + time + "\n";
}

struct Controlled {
  explicit Controlled(const std::string& text) : problem(assemble(scene_from_text(text, "c.yaml", {}), 1)) {}
  Problem problem;
  mpm::Simulation<2> simulation{problem.setup};
};

constexpr double direction_error = 0.02;  ///< of the probe, whose directions lie a few degrees apart

TEST(TimeControl, AtRestTakesTheWaveOfTheMaterialAtRest) {
  const double c = std::sqrt(1e3 * 0.7 / (1.3 * 0.4) / 1000);
  for (const char* method : {"{basis: cpdi}", "{basis: bspline2, formulation: total}"}) {
    Controlled run(controlled_scene(method));
    TimeControl control(run.problem, run.simulation.state());
    EXPECT_NEAR(control.wave_speed(), c, direction_error * c) << method;
    const double v = std::acos(-1.0);  // R h g' at the beginning, R = 1
    const double longest = 0.4 * 0.125 / (c + v);
    EXPECT_NEAR(control.next(run.simulation.state(), 0), longest, 0.1 * longest) << method;
    EXPECT_FALSE(control.stuck());
  }
}

TEST(TimeControl, FollowsTheStretchOfTheParticles) {
  Controlled run(controlled_scene("{basis: bspline2, formulation: total}"));
  mpm::State<2>& s = run.simulation.state();
  TimeControl control(run.problem, s);
  const double at_rest = control.wave_speed();
  s.column(mpm::Column::deformation_gradient, 1)[7] = 7;  // one particle, sheared
  for (int k = 0; k < 17; ++k) control.next(s, 0);
  const double stretch = 3.5 + std::sqrt(1 + 3.5 * 3.5), mu = 1 / 2.6, lambda = 0.3 / (1.3 * 0.4);
  const double expected = std::sqrt(mu + (lambda + mu) * stretch * stretch);
  EXPECT_GT(control.wave_speed(), 3 * at_rest);
  EXPECT_NEAR(control.wave_speed(), expected, direction_error * expected);
}

TEST(TimeControl, GivesUpWhereStepsWouldNotEnd) {
  Controlled run(controlled_scene("{basis: cpdi}"));
  mpm::State<2>& s = run.simulation.state();
  TimeControl control(run.problem, s);
  s.column(mpm::Column::velocity, 0)[7] = 1e9;
  for (int k = 0; k < 17; ++k) control.next(s, 0);
  EXPECT_TRUE(control.stuck());
}

TEST(TimeControl, MeetsHalfThePeriodAndTheEnd) {
  Controlled run(controlled_scene("{basis: cpdi}", "{control: current, end: 1.3}"));
  TimeControl control(run.problem, run.simulation.state());
  std::vector<double> times{0};
  while (times.back() < 1.3) times.push_back(control.next(run.simulation.state(), times.back()));
  EXPECT_EQ(times.back(), 1.3);
  for (const double mark : {0.5, 1.0}) {
    EXPECT_NE(std::find(times.begin(), times.end(), mark), times.end()) << mark;
  }
}

TEST(TimeControl, FindsWhatEqualStepsFindInFewerOfThem) {
  const std::vector<std::string> base{"output={particles: 0, pictures: false, report: false}"};
  std::vector<std::string> current = base;
  current.push_back("time.control=current");
  const auto equal = result_of_run("methods/best_total", base), free = result_of_run("methods/best_total", current);
  EXPECT_LT(free["steps"], equal["steps"]);
  const double error = equal["error"]["l2_max"];
  EXPECT_NEAR(free["error"]["l2_max"], error, 0.02 * error);  // the error is that of space
  EXPECT_FALSE(free["error"]["l2_half"].is_null());
  EXPECT_LE(free["health"]["courant"], 0.8 * 1.01);
}

TEST(TimeControl, IsRefusedBesideAFixedStep) {
  const std::string said = refusal_of(
      [] { scene_from_text(controlled_scene("{basis: cpdi}", "{control: current, step: 0.01}"), "c.yaml"); });
  EXPECT_NE(said.find("time.control: current takes steps by method.courant, and time.step fixes them"),
            std::string::npos)
      << said;
}

// The grid of a total formulation does not get thinner with the body: its steps must be shorter.
TEST(PlannedSteps, OfATotalFormulationFollowWavesAcrossTheReferenceConfiguration) {
  const auto problem_of = [](const char* formulation, const char* nu) {
    const std::string method = std::string("{basis: bspline2, formulation: ") + formulation + "}";
    const std::string model = std::string("neo_hookean, parameters: {E: 1e3, nu: ") + nu + "}";
    return assemble(scene_from_text(controlled_scene(method, "{end: 1}", model), "c.yaml"), 1);
  };
  const Problem updated = problem_of("updated", "0.499"), total = problem_of("total", "0.499");
  EXPECT_EQ(updated.reference_wave_speed, 0);
  EXPECT_EQ(fastest_signal(updated), updated.wave_speed + updated.particle_speed);
  EXPECT_EQ(fastest_signal(total), total.reference_wave_speed);
  EXPECT_GT(total.steps, 3 * updated.steps);
  const Problem soft = problem_of("total", "0.3");
  EXPECT_EQ(fastest_signal(soft), soft.wave_speed + soft.particle_speed);
}

}  // namespace
}  // namespace assay::drivers
