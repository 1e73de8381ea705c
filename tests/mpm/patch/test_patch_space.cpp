// SPDX-License-Identifier: BSD-3-Clause
// The patch tests in space: every basis stands them, and a defect of the third dimension that is planted into the
// passes of a step does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_patch_space {
namespace {

using SpaceDefect = DefectIn<3>;

struct EveryPatchedMethodInSpace : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, EveryPatchedMethodInSpace, testing::ValuesIn(one_of_each_basis()), way_name);

struct LongEveryPatchedMethodInSpace : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, LongEveryPatchedMethodInSpace, testing::ValuesIn(all_methods()), way_name);

TEST_P(EveryPatchedMethodInSpace, KeepsWhatItPromisesAndTellsTheRest) { expect_promises_kept<3>(GetParam()); }

TEST_P(LongEveryPatchedMethodInSpace, KeepsWhatItPromises) {
  const MethodReport report = run_patch_tests(GetParam(), quick_patch_bench<3>());
  EXPECT_EQ(report.tests.size(), 22u);
  EXPECT_EQ(failed_tests(report), std::set<std::string>());
}

Method flip_of(Basis basis, Formulation formulation = Formulation::updated, Update update = Update::usl) {
  return {basis, Transfer::flip, update, formulation};
}

Method moment_of(Basis basis) {
  Method method{basis, Transfer::apic};
  method.affine = Affine::moment;
  return method;
}

constexpr std::size_t x = 0, y = 1, z = 2;
const Method point_linear = flip_of(Basis::linear), boxes = flip_of(Basis::ugimp), convected = flip_of(Basis::cpdi),
             corners = flip_of(Basis::cpdi2), first = flip_of(Basis::cpdi, Formulation::updated, Update::usf),
             spline = flip_of(Basis::bspline2, Formulation::total);

constexpr auto no_slope_along_z = [](std::size_t d, int, int, double&, double& slope) {
  if (d == z) slope = 0;
};
constexpr auto no_first_slope_along_z = [](std::size_t d, int k, int, double&, double& slope) {
  if (d == z && k == 0) slope = 0;
};

const std::vector<Method> of_each_kind{point_linear, boxes, convected, corners, first, spline};

std::vector<SpaceDefect> weight_defects() {
  const auto nothing = [](State<3>&, const Instant&) {};
  return {{"the gradient along z is missing",
           "weights",
           true,
           nothing,
           {point_linear, boxes},
           {"weights.linear", "stress.total"},
           spoil<no_slope_along_z, 3>},
          {"the gradient of one layer of nodes is missing",
           "weights",
           true,
           nothing,
           {point_linear, boxes},
           {"weights.unity", "weights.linear", "translation", "stress.seeded"},
           spoil<no_first_slope_along_z, 3>},
          {"CPDI convects its domains with F_13 and F_31 exchanged",
           "weights",
           true,
           [](State<3>& s, const Instant&) { transpose(s, Column::deformation_gradient, x, z); },
           {convected, first},
           {"stress.deformed", "stress.graded"}}};
}

std::vector<SpaceDefect> stress_defects() {
  return {
      {"13 and 23 are exchanged",
       "forces",
       true,
       [](State<3>& s, const Instant&) { swap_stress(s, 4, 5); },
       of_each_kind,
       {"stress.total"}},
      {"22 and 33 are exchanged",
       "forces",
       true,
       [](State<3>& s, const Instant&) { swap_stress(s, 1, 2); },
       of_each_kind,
       {"stress.total"}},
      {"23 has the other sign",
       "forces",
       true,
       scale_components(Column::stress, {5}, -1, 1),
       of_each_kind,
       {"stress.total"}},
      {"13 is halved", "forces", true, scale_components(Column::stress, {4}, 0.5, 1), of_each_kind, {"stress.total"}},
      {"33 is a thousandth too large at some particles",
       "forces",
       true,
       scale_components(Column::stress, {2}, 1.001, 7),
       of_each_kind,
       {"stress.seeded", "stress.shifted", "stress.total"}},
      {"there is no force along z",
       "forces",
       false,
       [](State<3>& s, const Instant&) {
         for (std::size_t i = 0; i < s.force.nodes(); ++i) s.force.node(i)[z] = 0;
       },
       of_each_kind,
       {"stress.total"}}};
}

std::vector<SpaceDefect> motion_defects() {
  std::vector<SpaceDefect> defects{{"L_13 and L_31 are exchanged",
                                    "grid_to_particles",
                                    false,
                                    [](State<3>& s, const Instant&) { transpose(s, Column::velocity_gradient, x, z); },
                                    {point_linear, boxes, convected, corners},
                                    {"weights.linear"}},
                                   {"some velocity along z is lost",
                                    "grid_to_particles",
                                    false,
                                    scale_components(Column::velocity, {2}, 1 - 1e-9, 3),
                                    {point_linear, boxes, convected, corners, spline},
                                    {"momentum.linear", "translation"}},
                                   {"nodes without mass stand still",
                                    "unfold_massless",
                                    false,
                                    [](State<3>& s, const Instant&) {
                                      for (std::size_t i = 0; i < s.motion.nodes(); ++i) {
                                        if (s.inertia.node(i)[0] == 0) std::fill_n(s.motion.node(i), 6, 0.0);
                                      }
                                    },
                                    {point_linear},
                                    {"translation.lines"}},
                                   {"the corners fall behind along z",
                                    "grid_to_particles",
                                    false,
                                    scale_components(Column::corners, {2, 5, 8, 11, 14, 17, 20, 23}, 1 - 1e-4, 1),
                                    {corners},
                                    {"translation"}}};
  for (const auto& [i, j] : std::vector<std::pair<std::size_t, std::size_t>>{{x, y}, {x, z}, {y, z}}) {
    defects.push_back({"a component of the angular momentum changes its sign",
                       "affine",
                       false,
                       [i = i, j = j](State<3>& s, const Instant&) { transpose(s, Column::affine, i, j); },
                       {moment_of(Basis::cpdi), moment_of(Basis::bspline2)},
                       {"momentum.angular", "tilted.angular"}});
  }
  return defects;
}

TEST(PatchTestsInSpace, CatchDefectsOfTheWeights) {
  for (const SpaceDefect& defect : weight_defects()) expect_caught_in(defect);
}

TEST(LongPatchTestsInSpace, CatchDefectsOfTheStress) {
  for (const SpaceDefect& defect : stress_defects()) expect_caught_in(defect);
}

TEST(PatchTestsInSpace, CatchDefectsOfTheMotion) {
  for (const SpaceDefect& defect : motion_defects()) expect_caught_in(defect);
}

TEST(PatchBenchInSpace, HasACubeOfOneMetreWithTwoParticlesACellAndAxis) {
  const mpm::Setup<3> setup = patch_setup(convected, quick_patch_bench<3>(), 4);
  EXPECT_EQ(setup.seeds.size(), 512u);
  EXPECT_EQ(setup.grid.spacing, 0.25);
  EXPECT_NEAR(setup.seeds.volume() * 512, 1, 1e-15);
}

TEST(PatchBenchInSpace, EveryStressComponentIsLargeAndDiffersFromTheOthers) {
  const auto sigma = stress_at<3>(*elastic_material(), homogeneous_deformation<3>());
  const double largest = std::abs(*std::ranges::max_element(sigma, {}, [](double s) { return std::abs(s); }));
  for (std::size_t a = 0; a < sigma.size(); ++a) {
    EXPECT_GT(std::abs(sigma[a]), 0.1 * largest) << a;
    for (std::size_t b = 0; b < a; ++b) EXPECT_GT(std::abs(sigma[a] - sigma[b]), 0.03 * largest) << a << " " << b;
  }
}

TEST(PatchBenchInSpace, GradedSeedsFillTheCubeWithUnequalCuboids) {
  const Seeds<3> seeds = graded_seeds<3>(4);
  ASSERT_EQ(seeds.size(), 512u);
  double volume = 0, smallest = 1;
  std::array<double, 3> moment{};
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    volume += seeds.volume(p);
    for (std::size_t d = 0; d < 3; ++d) {
      moment[d] += seeds.volume(p) * seeds.X[d][p];
      smallest = std::min(smallest, seeds.half_edges[p][4 * d]);
    }
  }
  EXPECT_NEAR(volume, 1, 1e-14);
  for (const double component : moment) EXPECT_NEAR(component, 0, 1e-14);
  EXPECT_LT(smallest, 0.8 * seeds.half_size[0]);
}

TEST(PatchBenchInSpace, MomentumIsThatOfTheParticlesAboutEveryAxis) {
  Simulation<3> simulation(patch_setup(convected, quick_patch_bench<3>(), 4));
  State<3>& s = simulation.state();
  const Vec<3> spin{0.2, -0.5, 0.7};  // v = v_0 + spin x X
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vec<3> X = s.at<3>(Column::position, p);
    for (std::size_t d = 0; d < 3; ++d) {
      const std::size_t j = (d + 1) % 3, k = (d + 2) % 3;
      s.column(Column::velocity, d)[p] = static_cast<double>(d + 1) + spin[j] * X[k] - spin[k] * X[j];
    }
  }
  const Momentum<3> found = momentum_of(s);
  const double inertia = 1000.0 / 6 * (1 - 1.0 / 64);  // of points, rho a^5 / 6 of a solid
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_NEAR(found.linear[d], 1000.0 * static_cast<double>(d + 1), 1e-9);
    EXPECT_NEAR(found.angular[d], inertia * spin[d], 1e-9);
  }
}

}  // namespace
}  // namespace assay::mpm::test_patch_space
