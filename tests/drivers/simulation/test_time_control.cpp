// SPDX-License-Identifier: BSD-3-Clause
// Steps as long as the particles allow: they follow what waves there are, meet T/2 and the end, and are refused where
// they are fixed.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/simulation/exact_setup.hpp"

namespace assay::drivers::test_time_control {
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
  mpm::Simulation<2> simulation{with_exact_solution(problem)};
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

TEST(LongTimeControl, FindsWhatEqualStepsFindInFewerOfThem) {
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

Problem damped(const std::string& coefficients, const std::string& motion = "vortex, amplitude: {peak: 1}",
               const std::string& formulation = "total", const std::string& time = "{end: 0.5}") {
  return assemble(
      scene_from_text("motion: {type: " + motion +
                          "}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
                          "grid: {spacing: 0.125}\nmethod: {basis: bspline2, formulation: " +
                          formulation + "}\nforce: {response: closed_form}\ntime: " + time +
                          "\nremedies: {artificial_viscosity: " + coefficients + "}\n",
                      "d.yaml", {}),
      1);
}

/// Of v += -dt (w^2 u + 2 xi w v), u += dt v.
double spectral_radius(double dt, double w, double xi) {
  Eigen::Matrix2d step;
  step << 1 - dt * w * dt * w, dt * (1 - 2 * xi * w * dt), -dt * w * w, 1 - 2 * xi * w * dt;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(ViscousShortening, IsTheStabilityLimitOfDampedCentralDifferences) {
  constexpr double beyond = 1.001, h = 0.125;
  for (const double linear : {0.05, 0.5, 4.0}) {
    const Problem problem = damped("[" + std::to_string(linear) + ", 0]");
    const double c = problem.wave_speed, longest = h / (c * viscous_shortening(problem, c, 0));
    EXPECT_LT(spectral_radius(longest / beyond, 2 * c / h, linear), 1);
    EXPECT_GT(spectral_radius(longest * beyond, 2 * c / h, linear), 1);
  }
}

TEST(ViscousShortening, ActsOnPlannedStepsByTheShrinkingOfTheExactMotion) {
  EXPECT_EQ(damped("[0, 0]").viscous_shortening, 1);
  const double shears_alone = 0.2 + std::sqrt(1 + 0.2 * 0.2);
  const Problem vortex = damped("[0.2, 2]"), plain = damped("[0, 0]");
  EXPECT_NEAR(vortex.viscous_shortening, shears_alone, 1e-9);
  EXPECT_EQ(vortex.reference_wave_speed, plain.reference_wave_speed);
  EXPECT_NEAR(
      fastest_signal(vortex),
      std::max(shears_alone * vortex.reference_wave_speed, shears_alone * vortex.wave_speed + vortex.particle_speed),
      1e-9);
  EXPECT_GT(vortex.steps, plain.steps);
  const std::string squeezed = "homogeneous, period: 1, final: [[0.5, 0, 0], [0, 1, 0], [0, 0, 1]]";
  const Problem shrinks = damped("[0, 2]", squeezed, "updated");
  const double shrinking = fastest_shrinking(shrinks.scene), Q = 2 * 0.125 * shrinking;
  EXPECT_GT(shrinking, 0);
  EXPECT_NEAR(shrinks.viscous_shortening, (Q + std::hypot(Q, shrinks.wave_speed)) / shrinks.wave_speed, 1e-12);
}

TEST(ViscousShortening, OfCurrentStepsFollowsTheParticles) {
  for (const char* formulation : {"updated", "total"}) {
    const Problem problem = damped("[0.1, 2]", "vortex, amplitude: {peak: 1}", formulation, "{control: current}");
    mpm::Simulation<2> simulation(with_exact_solution(problem));
    mpm::State<2>& s = simulation.state();
    TimeControl at_rest(problem, s);
    const double before = at_rest.next(s, 0);
    for (std::size_t p = 0; p < s.particles; ++p) s.column(mpm::Column::velocity_gradient, 0)[p] = p == 5 ? -40 : 0;
    TimeControl shrinking(problem, s);
    const double c = shrinking.wave_speed(), v = std::acos(-1.0);
    const double factor = viscous_shortening(problem, c, 40);
    EXPECT_GT(factor, 5);
    EXPECT_NEAR(shrinking.next(s, 0), 0.4 * 0.125 / (factor * c + v), 0.03 * before) << formulation;
  }
}

// With steps that do not count it the sheared body dies of it, at t = 0.26 s.
TEST(ViscousShortening, LetsAShearedBodyLive) {
  const auto result = result_of_run("methods/best_total", {"output={particles: 0, pictures: false, report: false}",
                                                           "remedies.artificial_viscosity=[0.2, 2]", "time.end=0.5"});
  EXPECT_EQ(result["outcome"], "completed");
}

}  // namespace
}  // namespace assay::drivers::test_time_control
