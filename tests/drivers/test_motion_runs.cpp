// SPDX-License-Identifier: BSD-3-Clause
// The twisting ring, the axis-aligned motion and the bar in whole runs: they converge at the method's order, and what
// is planted in the model, the tractions, the acceleration or one component of P does not pass.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adapters/builtin.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/error_sampler.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/numeric/norms.hpp"
#include "mpm/simulation.hpp"
#include "mpm/step/surface_loads.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_motion_runs {
namespace {

const std::string motions = tree_folder() + "/configs/motions/";
constexpr double least_order = 1.9;   ///< of methods of second order, on the finer grids
constexpr double first_order = 1.15;  ///< that a run without defect has at least between the coarsest grids
constexpr double stalls = 0.7;        ///< of a defect: what halving h leaves of the error, at least
constexpr double stands_out = 4;      ///< its error over that of the run without it, on the finer grid

struct MotionCase {
  std::string name, scene;
  std::vector<std::string> sets;
  std::vector<double> spacings;  ///< each half of the one before [m]
};

const std::string total =
    "method={basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, "
    "integrator: leapfrog, courant: 0.4}";
const std::string updated =
    "method={basis: cpdi2, transfer: aflip, mass: series, terms: 2, integrator: leapfrog, "
    "courant: 0.4}";
const std::string clipped = "body={domain: ring, lattice: cartesian, cut: clipped, per_cell: [2, 2]}";
const std::string part = "body={domain: box, lower: [0, 0], upper: [0.75, 0.5], per_cell: [2, 2]}";

const std::string zener =
    "material={adapter: zener, parameters: {E: 4.0e3, nu: 0.3, relaxation_time: 0.1}, "
    "density: 1000}";

const std::vector<double> of_box{0.125, 0.0625, 0.03125, 0.015625};
const std::vector<MotionCase> box_cases{
    {"axis_aligned_total", "axis_aligned", {total}, of_box},
    {"axis_aligned_updated", "axis_aligned", {updated}, of_box},
    {"axis_aligned_periodic",
     "axis_aligned",
     {updated, "body={domain: square, lower: [-1, -1], upper: [1, 1], per_cell: [2, 2], periodic: both}"},
     {0.125, 0.0625, 0.03125}},
    {"axis_aligned_with_tractions", "axis_aligned", {total, "method.courant=0.1", part}, of_box},
    {"axis_aligned_zener", "axis_aligned", {updated, zener}, {0.125, 0.0625, 0.03125}},
    {"bar_total", "bar_1d", {total}, of_box},
    {"bar_with_traction", "bar_1d", {updated, part}, of_box}};
/// The same motions, planes and tractions with the other formulation.
const std::vector<MotionCase> more_box_cases{
    {"axis_aligned_with_tractions_updated", "axis_aligned", {updated, part}, of_box},
    {"bar_updated", "bar_1d", {updated}, of_box},
    {"bar_with_traction_total", "bar_1d", {total, part}, of_box}};
const std::vector<MotionCase> ring_cases{
    {"total_clipped", "twisting_ring", {total, clipped}, {0.1, 0.05, 0.025, 0.0125}},
    {"updated_polar", "twisting_ring", {updated}, {0.1, 0.05, 0.025, 0.0125}},
    {"zener", "twisting_ring", {updated, zener}, {0.1, 0.05, 0.025}},
    {"updated_clipped", "twisting_ring", {updated, clipped}, {0.1, 0.05, 0.025, 0.0125}}};

using Plant = std::function<void(Problem&, std::vector<mpm::Pass<2>>&)>;

/// Largest L2 of the displacement over time; `generator` makes the manufactured solution, null: the scene's material.
double largest_error(const MotionCase& which, double h, const Plant& plant = {},
                     const std::shared_ptr<const Material>& generator = nullptr) {
  constexpr int samples = 50;
  std::vector<std::string> sets = which.sets;
  sets.insert(sets.end(), {"grid.spacing=" + std::to_string(h), "force.cache=false", "output.accounts=false"});
  Problem problem = assemble(read_scene(motions + which.scene + ".yaml", sets), 1);
  const auto exact = exact_solution_of(problem.scene, generator ? generator : problem.material, problem.scene.time.end);
  const auto truth = exact_solution_of(problem.scene, problem.material, problem.scene.time.end);
  problem.setup.exact = exact;
  std::vector<mpm::Pass<2>> passes = mpm::compose(problem.setup);
  if (plant) plant(problem, passes);
  mpm::Simulation<2> simulation(problem.setup, passes);
  ErrorSampler sampler(problem, truth, simulation.state());
  const std::int64_t every = std::max<std::int64_t>(1, problem.steps / samples);
  double largest = 0;
  for (std::int64_t k = 0; k < problem.steps; ++k) {
    const double t = problem.time_of_step(k), next = problem.time_of_step(k + 1);
    if (simulation.step(t, next - t)) return INFINITY;
    if ((k + 1) % every != 0 && k + 1 != problem.steps) continue;
    const ErrorSample sample = sampler.sample(simulation.state(), next, simulation.velocity_time());
    largest = std::max(largest, sample.displacement.l2);
  }
  return largest;
}

void converges(const MotionCase& which) {
  std::vector<double> errors;
  for (const double h : which.spacings) errors.push_back(largest_error(which, h));
  for (std::size_t k = 1; k < errors.size(); ++k) {
    const double order = std::log2(errors[k - 1] / errors[k]);
    EXPECT_GT(order, k + 1 == errors.size() ? least_order : first_order) << errors[k - 1] << " " << errors[k];
  }
}

std::string case_name(const testing::TestParamInfo<MotionCase>& which) { return which.param.name; }

class BoxRun : public testing::TestWithParam<MotionCase> {};
TEST_P(BoxRun, ConvergesAtSecondOrder) { converges(GetParam()); }
const auto cases_of_box_run = one_of_each<BoxRun::ParamType>(3, testing::ValuesIn(box_cases));
INSTANTIATE_TEST_SUITE_P(Motions, BoxRun, testing::ValuesIn(cases_of_box_run.some), case_name);
INSTANTIATE_TEST_SUITE_P(LongMotions, BoxRun, testing::ValuesIn(cases_of_box_run.others), case_name);

class LongBoxRun : public testing::TestWithParam<MotionCase> {};
TEST_P(LongBoxRun, ConvergesAtSecondOrder) { converges(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Motions, LongBoxRun, testing::ValuesIn(more_box_cases), case_name);

class LongRingRun : public testing::TestWithParam<MotionCase> {};
TEST_P(LongRingRun, ConvergesAtSecondOrder) { converges(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Motions, LongRingRun, testing::ValuesIn(ring_cases), case_name);

// Consistent mass, quartic B-splines, Gauss points and a time step of fourth order.
TEST(BoxRun, ConvergesAtFourthOrder) {
  const MotionCase which{"",
                         "axis_aligned",
                         {"method={basis: bspline4, formulation: total, transfer: flip, mass: consistent, "
                          "integrator: symplectic_rkn4, courant: 0.2}",
                          "body={per_cell: [2, 2], lattice: gauss}"},
                         {}};
  const double coarse = largest_error(which, 0.125), fine = largest_error(which, 0.0625);
  EXPECT_LT(fine, 2e-7);
  EXPECT_GT(std::log2(coarse / fine), 3.8);
}

// The body on one side of its symmetry planes is the half of the one that is periodic.
TEST(BoxRun, SymmetryPlanesDoAsThePeriodicBody) {
  const double half = largest_error(box_cases[1], 0.125), whole = largest_error(box_cases[2], 0.125);
  EXPECT_NEAR(half, whole, 1e-10 * whole);
}

/// The scene's material with another lambda, and the same mu.
void plant_lambda(Problem& problem, std::vector<mpm::Pass<2>>&) {
  const double E = problem.material->parameter("E"), nu = problem.material->parameter("nu");
  const double mu = E / (2 * (1 + nu)), lambda = 1.2 * E * nu / ((1 + nu) * (1 - 2 * nu));
  const double wrong_nu = lambda / (2 * (lambda + mu));
  problem.setup.material =
      std::make_shared<const Material>(adapters::builtin_table("neo_hookean"),
                                       std::map<std::string, double>{{"E", 2 * mu * (1 + wrong_nu)}, {"nu", wrong_nu}});
}

/// Behind a pass of that name.
void insert_behind(std::vector<mpm::Pass<2>>& passes, std::string_view name, const mpm::Pass<2>& planted) {
  const auto at = std::find_if(passes.begin(), passes.end(), [&](const auto& pass) { return pass.name == name; });
  ASSERT_NE(at, passes.end()) << name;
  passes.insert(at + 1, planted);
}

/// Tractions of the wrong sign: twice each is taken off again.
void plant_sign_of_traction(Problem&, std::vector<mpm::Pass<2>>& passes) {
  mpm::Pass<2> planted;
  planted.name = "planted";
  planted.bind = [](mpm::State<2>& s) -> mpm::Kernel {
    return [&s, &loads = s.own<mpm::SurfaceLoads<2>>()](const mpm::Instant&) {
      for (std::size_t k = 0; k < loads.points.size(); ++k) {
        for (double& component : loads.points[k].force) component *= -2;
        loads.scatter(k, s.force.data());
      }
    };
  };
  insert_behind(passes, "traction", planted);
}

/// Without 2 rho. alpha. of a_theta.
void plant_coriolis(Problem&, std::vector<mpm::Pass<2>>& passes) {
  mpm::Pass<2> planted;
  planted.name = "planted";
  planted.bind = [](mpm::State<2>& s) -> mpm::Kernel {
    return [&s](const mpm::Instant& now) {
      for (std::size_t p = 0; p < s.particles; ++p) {
        const Vector3 X(s.column(mpm::Column::reference_position, 0)[p],
                        s.column(mpm::Column::reference_position, 1)[p], 0);
        const RingKinematics ring = ring_kinematics(*s.setup.motion, X.norm(), now.t);
        const Vector3 term = ring.cartesian(X, {0, 2 * ring.rho_rate * ring.alpha_rate});
        for (int d = 0; d < 2; ++d) s.column(mpm::Column::body_force, d)[p] -= term(d);
      }
    };
  };
  insert_behind(passes, "body_force", planted);
}

/// Neo-Hookean, one component of whose stress is 5 % too large.
template <int Component>
std::shared_ptr<const Material> with_wrong_component(double E, double nu) {
  static const assay_material* right = adapters::builtin_table("neo_hookean");
  static const assay_material table = [] {
    assay_material t = *right;
    t.extension = nullptr;
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      right->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      for (std::size_t p = 0; p < n; ++p) cauchy[Component * n + p] *= 1.05;
    };
    return t;
  }();
  return std::make_shared<const Material>(&table, std::map<std::string, double>{{"E", E}, {"nu", nu}});
}

/// Neither vanishes with h nor hides behind `right`, the method's own error at h/2 [m].
void is_caught(const std::string& what, const MotionCase& which, double h, double right, const Plant& plant,
               const std::shared_ptr<const Material>& generator = {}) {
  const double coarse = largest_error(which, h, plant, generator);
  const double fine = largest_error(which, 0.5 * h, plant, generator);
  EXPECT_GT(fine, stands_out * right) << what << ", " << which.name;
  EXPECT_TRUE(!std::isfinite(coarse) || fine > stalls * coarse)
      << what << ", " << which.name << " " << coarse << " " << fine;
}

void planted_is_caught(const std::vector<MotionCase>& cases) {
  for (const MotionCase& which : cases) {
    if (which.sets.back() == zener) continue;
    const double right = largest_error(which, 0.5 * 0.0625);
    is_caught("lambda", which, 0.0625, right, plant_lambda);
    is_caught("P11", which, 0.0625, right, {}, with_wrong_component<0>(1e4, 0.3));
    if (which.sets.back() == part) is_caught("sign", which, 0.0625, right, plant_sign_of_traction);
  }
}

TEST(PlantedInTheBox, IsCaught) { planted_is_caught({box_cases.front()}); }
TEST(LongPlantedInTheBox, IsCaught) {
  planted_is_caught(box_cases);
  planted_is_caught(more_box_cases);
}

// Ten times as stiff as the scene's: what is wrong with the stress is then not hidden behind the inertia.
TEST(LongPlantedInTheRing, IsCaught) {
  for (MotionCase which : {ring_cases[0], ring_cases[1]}) {
    which.sets.push_back("material.parameters.E=1e4");
    const double right = largest_error(which, 0.5 * 0.05);
    is_caught("lambda", which, 0.05, right, plant_lambda);
    is_caught("sign", which, 0.05, right, plant_sign_of_traction);
    is_caught("Coriolis", which, 0.05, right, plant_coriolis);
    is_caught("P12", which, 0.05, right, {}, with_wrong_component<1>(1e4, 0.3));
  }
}

}  // namespace
}  // namespace assay::drivers::test_motion_runs
