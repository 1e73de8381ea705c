// SPDX-License-Identifier: BSD-3-Clause
// Homogeneous motions under tractions on all faces: to rounding, with the form that is stable, for every stiffness,
// grid and method of which that is promised; and not, with the others.
#include <gtest/gtest.h>

#include <cmath>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_traction {
namespace {

constexpr double rounding = 1e-12;        ///< [m], of E up to 1e6
constexpr double stiff_rounding = 1e-11;  ///< of E = 1e9: what is left grows with the number of steps
const std::string table1 = tree_folder() + "/configs/paper/table1_traction.yaml";
const std::string stretch = tree_folder() + "/configs/motions/rotating_stretch.yaml";
const std::string cube = tree_folder() + "/configs/space/homogeneous.yaml";
const std::string stretch_in_space = tree_folder() + "/configs/space/rotating_stretch.yaml";

/// Under the tractions of a material that is `stiffer` times as stiff.
template <int Dim>
Result result_in(const Scene& scene, double stiffer) {
  ProblemIn<Dim> problem = assemble<Dim>(scene, 1);
  Scene other = problem.scene;
  other.material.parameters["E"] *= stiffer;
  std::string library;
  const auto material = stiffer == 1 ? problem.material : material_of(other, library);
  const auto exact = exact_solution_of(problem.scene, material, problem.scene.time.end);
  const ScratchFolder scratch;
  OutputFolder folder(scratch / "out");
  Snapshots<Dim> snapshots(problem, folder);
  Progress progress("", true);
  Result result;
  simulate(problem, exact, snapshots, progress, result);
  return result;
}

Result result_of(const std::string& path, std::vector<std::string> sets, double stiffer = 1) {
  sets.insert(sets.end(), {"output.particles=0", "output.pictures=false", "output.report=false"});
  const Scene scene = read_scene(path, sets);
  return in_dimension(scene, [&]<int Dim>(std::integral_constant<int, Dim>) { return result_in<Dim>(scene, stiffer); });
}

std::string number(double x) { return std::to_string(x); }

struct Case {
  std::string name;
  std::vector<std::string> method;
  double stiffest = 1e9, softest_stretch = 0.4;  ///< up to which, and from which on, it is promised
};

const std::vector<Case> cases{{"cpdi2", {"method.basis=cpdi2"}},
                              {"cpdi", {"method.basis=cpdi"}, 1e6, 1},
                              {"ugimp_virtual", {"method.basis=ugimp", "traction.algorithm=virtual_stress"}},
                              {"bspline2_virtual", {"method.basis=bspline2", "traction.algorithm=virtual_stress"}},
                              {"ugimp_total", {"method.basis=ugimp", "method.formulation=total"}, 1e9, 1},
                              {"bspline2_total", {"method.basis=bspline2", "method.formulation=total"}, 1e9, 1}};

Result table1_of(const Case& which, double E, int cells, double stretched, std::vector<std::string> more = {}) {
  std::vector<std::string> sets = which.method;
  sets.insert(sets.end(), {"material.parameters.E=" + number(E), "grid.spacing=" + number(1.0 / cells),
                           "motion.final=[[" + number(stretched) + ", 0, 0], [0, 1, 0], [0, 0, 1]]"});
  sets.insert(sets.end(), more.begin(), more.end());
  return result_of(table1, sets);
}

class Traction : public testing::TestWithParam<Case> {};

const std::vector<double> stretches{2, 4, 0.4};

void holds_to_rounding(const Case& which, double E, const std::vector<int>& cells, double limit,
                       const std::vector<double>& to = stretches) {
  for (const double stretched : to) {
    if (E > which.stiffest || stretched < which.softest_stretch) continue;
    for (const int n : cells) {
      const Result result = table1_of(which, E, n, stretched);
      EXPECT_EQ(result.outcome, "completed") << "E = " << E << ", " << n << " cells, " << stretched;
      EXPECT_LE(result.error.l2_max.value_or(INFINITY), limit) << "E = " << E << ", " << n << " cells, " << stretched;
      EXPECT_FALSE(result.growth) << "E = " << E << ", " << n << " cells, " << stretched;
    }
  }
}

TEST_P(Traction, HoldsToRounding) {
  for (const double E : {1e3, 1e6}) holds_to_rounding(GetParam(), E, {2, 4, 8}, rounding);
}

TEST_P(Traction, HoldsToRoundingWhereItIsStiff) { holds_to_rounding(GetParam(), 1e9, {2, 4}, stiff_rounding); }

// The cube of configs/space: sheared in all planes, and squeezed with shear.
Result cube_of(const Case& which, double E, int cells, const std::string& final, std::vector<std::string> more = {}) {
  std::vector<std::string> sets = which.method;
  sets.insert(sets.end(), {"material.parameters.E=" + number(E), "grid.spacing=" + number(1.0 / cells)});
  if (!final.empty()) sets.push_back("motion.final=" + final);
  sets.insert(sets.end(), more.begin(), more.end());
  return result_of(cube, sets);
}

const std::string squeezed = "[[0.7, 0.1, 0], [0, 0.8, -0.1], [0.1, 0.05, 0.9]]";

void holds_to_rounding_in_space(const Case& which, double E, const std::vector<int>& cells,
                                const std::vector<std::string>& to) {
  for (const std::string& final : to) {
    if (final == squeezed && which.softest_stretch > 0.7) continue;
    for (const int n : cells) {
      const Result result = cube_of(which, E, n, final);
      EXPECT_EQ(result.outcome, "completed") << "E = " << E << ", " << n << " cells, " << final;
      EXPECT_LE(result.error.l2_max.value_or(INFINITY), rounding) << "E = " << E << ", " << n << " cells, " << final;
    }
  }
}

TEST_P(Traction, HoldsToRoundingInSpace) {
  holds_to_rounding_in_space(GetParam(), 1e3, {2, 4, 8}, {"", squeezed});
  holds_to_rounding_in_space(GetParam(), 1e6, {2, 4}, {"", squeezed});
}

class LongTraction : public testing::TestWithParam<Case> {};

// Stiff bodies on the finest grids take most of the steps: they are stretched once, the farthest.
TEST_P(LongTraction, HoldsToRoundingOnFineGrids) {
  holds_to_rounding(GetParam(), 1e3, {16, 32}, rounding);
  holds_to_rounding(GetParam(), 1e6, {16}, rounding);
  holds_to_rounding(GetParam(), 1e6, {32}, rounding, {4});
  holds_to_rounding(GetParam(), 1e9, {8}, stiff_rounding);
  holds_to_rounding(GetParam(), 1e9, {16}, stiff_rounding, {4});
}

TEST_P(LongTraction, HoldsToRoundingInSpaceOnFineGrids) {
  holds_to_rounding_in_space(GetParam(), 1e6, {8}, {"", squeezed});
}

INSTANTIATE_TEST_SUITE_P(Methods, Traction, testing::ValuesIn(cases),
                         [](const auto& which) { return which.param.name; });

INSTANTIATE_TEST_SUITE_P(Methods, LongTraction, testing::ValuesIn(cases),
                         [](const auto& which) { return which.param.name; });

// A homogeneous F of any kind, shear included.
TEST(TractionMotions, CompressionShearAndBiaxial) {
  for (const char* final : {"[[0.7, 0, 0], [0, 0.8, 0], [0, 0, 1]]", "[[1, 0.8, 0], [0, 1, 0], [0, 0, 1]]",
                            "[[1.5, 0.3, 0], [-0.2, 1.4, 0], [0, 0, 1]]", "[[1.6, 0, 0], [0, 0.8, 0], [0, 0, 1]]"}) {
    const Result result = result_of(table1, {"motion.final=" + std::string(final)});
    EXPECT_LE(result.error.l2_max.value_or(INFINITY), rounding) << final;
  }
}

// In space the undeformed faces leave an error, too, and so do tractions at particles.
TEST(TractionAlgorithms, OtherThanTheDefaultErrInSpace) {
  for (const int n : {2, 4}) {
    EXPECT_GT(cube_of(cases[0], 1e6, n, "", {"traction.algorithm=undeformed_edges"}).error.l2_max.value_or(0), 1e-3)
        << n;
    EXPECT_GT(cube_of(cases[0], 1e6, n, "", {"traction.algorithm=particles"}).error.l2_max.value_or(0), 1e-3) << n;
  }
}

// What the paper's table is close to, .0733, .0724 and .0724 m; and tractions at particles, of first order.
TEST(TractionAlgorithms, UndeformedEdgesLeaveAnErrorThatNoGridHeals) {
  double lumped_before = INFINITY;
  for (const int n : {2, 4, 8}) {
    const Result undeformed = table1_of(cases[0], 1e6, n, 2, {"traction.algorithm=undeformed_edges"});
    EXPECT_NEAR(undeformed.error.l2_end.value_or(INFINITY), 0.045, 0.003) << n;
    const double lumped =
        table1_of(cases[0], 1e6, n, 2, {"traction.algorithm=particles"}).error.l2_end.value_or(INFINITY);
    EXPECT_GT(lumped, 1e-3) << n;
    EXPECT_LT(lumped, 0.6 * lumped_before) << n;
    lumped_before = lumped;
  }
}

// P N dA0 on a compressed body: it wants to turn round.
TEST(TractionForms, TheUnstableOneGrowsWithTheWaveSpeedAndSaysSo) {
  const auto rate = [](double E, double end) {
    const Result result =
        table1_of(cases[0], E, 8, 0.4, {"traction.form=reference", "time.end=" + number(end), "output.errors=200"});
    EXPECT_TRUE(result.growth) << E;
    EXPECT_NE(result.warnings.back().find("take traction.form: follower"), std::string::npos);
    return result.growth ? result.growth->rate : 0;
  };
  const double soft = rate(1e6, 0.6), stiff = rate(1e8, 0.2);
  EXPECT_GT(soft, 40);
  EXPECT_LT(soft, 120);
  EXPECT_GT(stiff / soft, 3);  // 10 by the wave speed; the rounding of the stiff body has grown up at less compression
}

TEST(TractionForms, TheDefaultIsTheStableOne) {
  const auto form = [](const std::string& stretched, const std::string& algorithm) {
    const Problem problem =
        assemble(read_scene(table1, {"motion.final=[[" + stretched + ", 0, 0], [0, 1, 0], [0, 0, 1]]",
                                     "traction.algorithm=" + algorithm}),
                 1);
    return problem.setup.traction->form;
  };
  EXPECT_EQ(form("2", "edges"), mpm::TractionForm::reference);
  EXPECT_EQ(form("0.4", "edges"), mpm::TractionForm::follower);
  EXPECT_EQ(form("2", "virtual_stress"), mpm::TractionForm::reference);
  EXPECT_EQ(form("0.4", "virtual_stress"), mpm::TractionForm::follower);
}

// Negative control: tractions of a material that is 1 % stiffer, which is a wrong sigma_hat as well.
TEST(TractionNegativeControl, AnErrorOfOnePercentIsCaught) {
  for (const std::string& scene : {table1, cube}) {
    for (const std::string algorithm : {"edges", "virtual_stress"}) {
      const Result result = result_of(scene, {"traction.algorithm=" + algorithm}, 1.01);
      EXPECT_GT(result.error.l2_max.value_or(INFINITY), 1e-3) << scene << ": " << algorithm;
    }
  }
}

// Momentum, its moment and energy against impulse and work of the tractions.
TEST(TractionAccounts, Balance) {
  for (const std::string formulation : {"updated", "total"}) {
    const Result result =
        result_of(stretch, {"method.basis=cpdi", "method.formulation=" + formulation, "time.step=0.001"});
    EXPECT_LT(result.drift.momentum.value_or(INFINITY), 1e-10) << formulation;
    EXPECT_LT(result.drift.angular_momentum.value_or(INFINITY), 1e-2) << formulation;
    EXPECT_LT(result.drift.energy.value_or(INFINITY), 1e-2) << formulation;
  }
}

// Body force, tractions and the method's time step together: the largest errors of these steps, each half the one
// before.
std::vector<double> errors_in_time(const std::string& scene, const std::string& rotate, double h,
                                   const std::vector<double>& steps) {
  std::vector<double> errors;
  for (const double dt : steps) {
    const Result result =
        result_of(scene, {"motion.rotate=" + rotate, "grid.spacing=" + number(h), "time.step=" + number(dt)});
    errors.push_back(result.error.l2_max.value_or(INFINITY));
  }
  for (std::size_t k = 0; k + 1 < errors.size(); ++k) {
    EXPECT_NEAR(std::log2(errors[k] / errors[k + 1]), 2, 0.05) << scene << ": " << rotate << " h = " << h;
  }
  return errors;
}

TEST(RotatingStretchRun, IsOfSecondOrderInTimeWhateverTheGrid) {
  for (const std::string rotate : {"simultaneous", "after"}) {
    const std::vector<double> steps{0.01, 0.005, 0.0025, 0.00125};
    const double coarse = errors_in_time(stretch, rotate, 0.25, steps).back();
    const double fine = errors_in_time(stretch, rotate, 0.125, steps).back();
    EXPECT_LT(std::max(coarse, fine) / std::min(coarse, fine), 1.5) << rotate;
  }
}

// About (1, 2, 3), on cells of a half, a quarter and an eighth.
TEST(LongRotatingStretchRun, InSpaceToo) {
  for (const std::string rotate : {"simultaneous", "after"}) {
    const double coarse = errors_in_time(stretch_in_space, rotate, 0.5, {0.01, 0.005, 0.0025})[1];
    const double middle = errors_in_time(stretch_in_space, rotate, 0.25, {0.01, 0.005, 0.0025})[1];
    const double fine = errors_in_time(stretch_in_space, rotate, 0.125, {0.005}).back();
    EXPECT_LT(std::max({coarse, middle, fine}) / std::min({coarse, middle, fine}), 1.1) << rotate;
  }
}

// With histories: J2 within the error of its increments, Zener as smooth models.
TEST(TractionMaterials, WithHistory) {
  const std::string zener =
      "material={adapter: zener, parameters: {E: 1.0e6, nu: 0.25, viscous_ratio: 0.5, relaxation_time: 0.3}, "
      "density: 1000}";
  const std::string j2 =
      "material={adapter: j2_multiplicative, parameters: {E: 1.0e6, nu: 0.25, yield_stress: 2.0e4, "
      "hardening_modulus: 1.0e5}, density: 1000}";
  EXPECT_LT(result_of(table1, {zener}).error.l2_max.value_or(INFINITY), 1e-6);
  EXPECT_LT(result_of(table1, {j2, "motion.final=[[1.1, 0, 0], [0, 1, 0], [0, 0, 1]]"}).error.l2_max.value_or(INFINITY),
            1e-6);
}

}  // namespace
}  // namespace assay::drivers::test_traction
