// SPDX-License-Identifier: BSD-3-Clause
// The exact solutions under an initial stress, and runs of particles that begin with it.
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/exact/exact_fields.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"

namespace assay::drivers::test_initial_stress {
namespace {

constexpr double rho = 1000, now = 0.37, step = 4e-3;
constexpr double of_sheet = 1e-6;    ///< of an interpolation, and of differences of it, of the largest
constexpr double of_history = 1e-7;  ///< between two sheets of one history, of the largest stress

const std::string jaumann = "hypoelastic_jaumann, parameters: {E: 1.0e+5}";
const std::string vortex = "{type: vortex, profile_power: 4, amplitude: {type: one_minus_cosine, peak: 0.1}}";
const std::string twist = "{type: twisting_ring, expansion: 0.02, amplitude: {peak: 0.05}}";

Scene scene_of(const std::string& motion, const std::string& material, const std::string& stress,
               const std::string& more = {}) {
  return scene_from_text("motion: " + motion + "\nmaterial: {density: 1000, adapter: " + material +
                             (stress.empty() ? "" : ", initial_stress: " + stress) + "}\n" + more,
                         "scene.yaml");
}

ExactSolutionPtr solution_of(const Scene& given) {
  Scene scene = given;
  scene.force.cache = false;
  std::string library;
  const auto material = material_of(scene, library);
  return exact_solution_of_points(scene, material, 1);
}

Vector3 force_by_differences(const ExactSolution& exact, const Vector3& X, double t) {
  const auto slice = exact.slice(t);
  Vector3 divergence = Vector3::Zero();
  for (int d = 0; d < 3; ++d) {
    divergence += central_difference(
        [&](int k) { return Vector3(slice->first_piola_kirchhoff(X + k * step * Vector3::Unit(d)).col(d)); }, step);
  }
  return slice->state(X).a - divergence / rho;
}

const std::vector<Vector3> places{{0.75, 0.45, 0}, {-0.62, 0.77, 0}, {0.3, -0.95, 0}};

/// The balance of momentum b = a - DIV(P)/rho0 by differences of P, and the stress at rest.
void expect_balance(const Scene& scene) {
  const auto exact = solution_of(scene);
  double largest = 0, off = 0;
  for (const Vector3& X : places) {
    const Vector3 found = exact->at(X, now).stress.body_force, wanted = force_by_differences(*exact, X, now);
    largest = std::max(largest, wanted.norm()), off = std::max(off, (found - wanted).norm());
    const Tensor at_rest = exact->at(X, 0).stress.cauchy;
    EXPECT_LT((at_rest - scene.initial_cauchy()).norm(), 1e-9 * scene.initial_cauchy().norm());
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(off, of_sheet * largest);
}

TEST(InitialStress, TheBalanceOfMomentumHoldsInRings) {
  const std::string pressure = "[-2.0e+3, -2.0e+3, -2.0e+3, 0, 0, 0]";
  expect_balance(scene_of(vortex, jaumann, pressure));
  expect_balance(scene_of(twist, jaumann, pressure));
  expect_balance(scene_of(twist, jaumann, "[-2.0e+3, -2.0e+3, -1.0e+3, 0, 0, 0]"));  // about the axis
}

TEST(InitialStress, TheBalanceOfMomentumHoldsInTheUnitBox) {
  expect_balance(scene_of("{type: axis_aligned, amplitude: {type: sine, peak: 0.05}, wave_speed: 1}", jaumann,
                          "[-2.0e+3, -1.0e+3, -1.5e+3, 0, 0, 0]"));
}

/// Co-rotated rates turn a pressure into itself, and this motion keeps the volume.
TEST(InitialStress, APressureStaysUnderAnIsochoricMotionOfAModelThatDoesNotSeeIt) {
  const double p = 2e3;
  const auto free = solution_of(scene_of(vortex, jaumann, ""));
  const auto under = solution_of(scene_of(vortex, jaumann, "[-2.0e+3, -2.0e+3, -2.0e+3, 0, 0, 0]"));
  for (const Vector3& X : places) {
    const ExactPoint one = free->at(X, now), other = under->at(X, now);
    const double size = other.stress.cauchy.norm();
    EXPECT_LT((other.stress.cauchy + p * Tensor::Identity() - one.stress.cauchy).norm(), of_history * size);
    EXPECT_LT((other.stress.body_force - one.stress.body_force).norm(), of_sheet * one.stress.body_force.norm());
  }
}

/// The cone at a constant pressure p is a cylinder of the cohesion k + 3 friction p; simple shear keeps the volume.
TEST(InitialStress, ThePressureIsASoilsStrength) {
  const std::string shear = "{type: homogeneous, final: [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]}";
  const std::string cone = "drucker_prager, parameters: {E: 1.0e+5, cohesion: 200, friction: 0.2, dilatancy: 0}";
  const std::string cylinder = "drucker_prager, parameters: {E: 1.0e+5, cohesion: 1100, friction: 0, dilatancy: 0}";
  const auto deviator = [&](const std::string& material, const std::string& stress) -> Tensor {
    const Tensor s = solution_of(scene_of(shear, material, stress))->at(places[0], 0.7).stress.cauchy;
    return s - s.trace() / 3 * Tensor::Identity();
  };
  const Tensor found = deviator(cone, "[-1.5e+3, -1.5e+3, -1.5e+3, 0, 0, 0]"), wanted = deviator(cylinder, "");
  EXPECT_LT((found - wanted).norm(), of_history * wanted.norm());
  EXPECT_GT((deviator(cone, "") - wanted).norm(), 0.5 * wanted.norm());  // it flows far earlier
}

TEST(InitialStress, AnyTensorIsTheSameEverywhereWhereFIs) {
  const Scene scene = scene_of("{type: rotating_stretch, stretch: 0.06, shear: 0.08, rotation: 1.1, axis: [1, 2, 3]}",
                               jaumann, "[1.0e+3, -2.0e+3, 5.0e+2, 3.0e+2, -4.0e+2, 6.0e+2]", "dimension: 3\n");
  const auto exact = solution_of(scene);
  EXPECT_LT((exact->at(places[0], 0).stress.cauchy - scene.initial_cauchy()).norm(), 1e-9);
  EXPECT_LT((exact->at(places[0], now).stress.cauchy - exact->at(places[1], now).stress.cauchy).norm(), 1e-9);
}

std::string refused(const std::string& motion, const std::string& stress, const std::string& more = {}) {
  return refusal_of([&] { scene_of(motion, jaumann, stress, more); });
}

TEST(InitialStress, IsRefusedWhereTheMotionIsNoSolution) {
  EXPECT_NE(refused(vortex, "[-1, -2, -1, 0, 0, 0]").find("scene.yaml:2:"), std::string::npos);
  EXPECT_NE(refused(vortex, "[-1, -2, -1, 0, 0, 0]").find("equal components 11 and 22 and no shear"),
            std::string::npos);
  EXPECT_NE(refused("{type: vortex3d}", "[-1, -1, -1, 0, 0, 0]").find("is not there yet for vortex3d"),
            std::string::npos);
  EXPECT_NE(refused("{type: axis_aligned}", "[-1, -1, -1, 1, 0, 0]").find("must have no shear"), std::string::npos);
  EXPECT_NE(refused("{type: homogeneous, final: [[2, 0, 0], [0, 1, 0], [0, 0, 1]]}", "[0, 0, 0, 0, 1, 0]")
                .find("dimension: 3"),
            std::string::npos);
  EXPECT_NE(refused(vortex, "[-1, -1]").find("6 numbers"), std::string::npos);
  Scene elastic = scene_of(vortex, "neo_hookean, parameters: {E: 1.0e+5}", "[-1, -1, -1, 0, 0, 0]");
  EXPECT_NE(refusal_of([&] { solution_of(elastic); }).find("material.initial_stress: material 'neo_hookean' does not"),
            std::string::npos);
}

/// Errors of a soil's vortex on two grids.
std::array<double, 2> errors(const std::vector<std::string>& sets) {
  std::array<double, 2> found{};
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<std::string> all{k == 0 ? "grid.spacing=0.125" : "grid.spacing=0.0625", "motion.profile_power=4",
                                 "method.courant=0.2", "time.end=0.5"};
    all.insert(all.end(), sets.begin(), sets.end());
    found[k] = result_of_run("models/vortex_drucker_prager_pressure", all)["error"]["l2_max"].get<double>();
  }
  return found;
}

/// As large an error as without, on every body, and it falls as fast.
TEST(LongInitialStress, RunsConvergeAsTheyDoWithoutIt) {
  const std::string none = "material.initial_stress=[0, 0, 0, 0, 0, 0]", strong = "material.parameters.cohesion=1000";
  const std::array<double, 2> free = errors({none, strong});
  for (const std::vector<std::string>& body :
       {std::vector<std::string>{}, std::vector<std::string>{"body.outside=free"},
        std::vector<std::string>{"body={domain: ring}"}}) {
    const std::array<double, 2> under = errors(body);
    EXPECT_GT(under[0] / under[1], 3);  // of order 2
    EXPECT_LT(under[1], 2 * free[1]);
  }
}

}  // namespace
}  // namespace assay::drivers::test_initial_stress
