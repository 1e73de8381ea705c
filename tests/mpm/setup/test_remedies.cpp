// SPDX-License-Identifier: BSD-3-Clause
// Each remedy does what it says to the state, and leaves alone what it says it does.
#include "mpm/setup/method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/motion/kinds/rigid.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/mpm/basis_cases.hpp"
#include "tests/mpm/effect_keys.hpp"
#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_remedies {
namespace {

constexpr double rounding = 1e-13;

/// Those that are asked for, as a scene asks.
struct Remedies {
  AntiLocking anti_locking = AntiLocking::none;
  double largest_domain = 0, small_mass = 0;
  std::array<double, 2> viscosity{};

  EffectOptions options() const {
    EffectOptions told;
    const std::vector<double> C(viscosity.begin(), viscosity.end());
    EXPECT_TRUE(tell(told, "remedies.anti_locking", value_of(anti_locking)));
    EXPECT_TRUE(tell(told, "remedies.largest_domain", largest_domain));
    EXPECT_TRUE(tell(told, "remedies.small_mass", small_mass));
    EXPECT_TRUE(tell(told, "remedies.artificial_viscosity", C));
    return told;
  }
};

/// A square of 4 x 4 cells with 2 x 2 particles each.
Setup<2> square(Method method, Remedies remedies) {
  Setup<2> setup;
  setup.method = method;
  setup.options = remedies.options();
  setup.wave_speed = 2;
  setup.grid.spacing = 0.5;
  setup.grid.first = {-3, -3};
  setup.grid.count = {12, 12};
  setup.seeds.half_size.fill(0.125);
  for (int j = 0; j < 8; ++j) {
    for (int i = 0; i < 8; ++i) {
      setup.seeds.X[0].push_back(0.125 + 0.25 * i);
      setup.seeds.X[1].push_back(0.125 + 0.25 * j);
    }
  }
  setup.density = 3;
  setup.material = elastic_material(100);
  setup.motion = Rigid{};
  return setup;
}

Method method_of(Basis basis, Formulation formulation = Formulation::updated) {
  Method method;
  method.basis = basis;
  method.formulation = formulation;
  return method;
}

/// The pass of that name in the step of the state's setup.
void run_pass(const std::string& name, State<2>& s, const Instant& now) {
  const std::vector<Pass<2>> passes = compose(s.setup);
  const auto pass = std::find_if(passes.begin(), passes.end(), [&](const auto& one) { return one.name == name; });
  ASSERT_NE(pass, passes.end()) << name;
  const Kernel kernel = pass->bind(s);
  if (kernel.begin) kernel.begin(now);
  if (kernel.block) {
    EXPECT_EQ(kernel.block(now, {0, s.particles, nullptr, nullptr}), none_bad);
  }
}

void randomize(State<2>& s, Column column, int components, double size, Random& random) {
  for (int c = 0; c < components; ++c) {
    for (std::size_t p = 0; p < s.particles; ++p) s.column(column, c)[p] += size * random();
  }
}

Mat<2> tensor_at(const State<2>& s, Column column, std::size_t p) {
  Mat<2> found;
  for (int c = 0; c < 4; ++c) found[static_cast<std::size_t>(c)] = s.column(column, c)[p];
  return found;
}

/// Cell of a particle in units of the grid.
int cell_of(const State<2>& s, std::size_t p) {
  return 100 * static_cast<int>(std::floor(2 * s.column(Column::position, 1)[p])) +
         static_cast<int>(std::floor(2 * s.column(Column::position, 0)[p]));
}

class AntiLockingOf : public testing::TestWithParam<Formulation> {};

// By a brute-force twin: current over base volume of a cell, and (J averaged / J)^(1/2) of each of its particles.
TEST_P(AntiLockingOf, CellsGiveTheirParticlesOneVolumeRatio) {
  const bool total = GetParam() == Formulation::total;
  Simulation<2> simulation(square(method_of(Basis::bspline2, GetParam()), {.anti_locking = AntiLocking::cell}));
  State<2>& s = simulation.state();
  Random random(7);
  randomize(s, Column::deformation_gradient, 4, 0.2, random);
  randomize(s, Column::velocity_gradient, 4, 2, random);
  const Instant now{0, 0.05};
  run_pass("step_volumes", s, now);
  run_pass("average_volume", s, now);
  std::map<int, std::array<double, 2>> sums;
  std::vector<double> own(s.particles);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Mat<2> F = tensor_at(s, Column::deformation_gradient, p), L = tensor_at(s, Column::velocity_gradient, p);
    const Mat<2> rate = total ? L : product<2>(L, F);
    Mat<2> after = F;
    for (std::size_t c = 0; c < 4; ++c) after[c] += now.dt * rate[c];
    const double base = total ? 1 : determinant<2>(F);
    own[p] = determinant<2>(after) / base;
    sums[cell_of(s, p)][0] += base;
    sums[cell_of(s, p)][1] += determinant<2>(after);
  }
  EXPECT_EQ(sums.size(), 16u);
  for (std::size_t p = 0; p < s.particles; ++p) {
    const auto [base, after] = sums[cell_of(s, p)];
    EXPECT_NEAR(s.column(Column::volume_scale, 0)[p], std::sqrt(after / base / own[p]), rounding);
  }
}

// A volume ratio that is the same everywhere is nobody's to change; one that is linear in x the nodes change at the
// body's rim alone, where they know one side.
TEST_P(AntiLockingOf, LeavesAUniformVolumeRatioAlone) {
  for (const AntiLocking over : {AntiLocking::cell, AntiLocking::node}) {
    Simulation<2> simulation(square(method_of(Basis::bspline2, GetParam()), {.anti_locking = over}));
    State<2>& s = simulation.state();
    for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity_gradient, 0)[p] = 3;
    run_pass("step_volumes", s, {0, 0.1});
    run_pass("average_volume", s, {0, 0.1});
    for (std::size_t p = 0; p < s.particles; ++p) EXPECT_NEAR(s.column(Column::volume_scale, 0)[p], 1, rounding);
  }
}

std::string formulation_name(const testing::TestParamInfo<Formulation>& way) {
  return way.param == Formulation::total ? "total" : "updated";
}

INSTANTIATE_TEST_SUITE_P(Formulations, AntiLockingOf, testing::Values(Formulation::updated, Formulation::total),
                         formulation_name);

// Where the grid moves with the body F keeps the averaged J; where it does not F stays the gradient of the motion.
TEST(AntiLockingKeepsF, ScaledWhereTheGridMovesAlone) {
  for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
    const bool total = formulation == Formulation::total;
    Simulation<2> simulation(square(method_of(Basis::bspline2, formulation), {.anti_locking = AntiLocking::cell}));
    State<2>& s = simulation.state();
    Random random(11);
    randomize(s, Column::velocity, 2, 0.5, random);
    ASSERT_FALSE(simulation.step(0, 0.01));
    std::map<int, std::vector<double>> ratios;
    for (std::size_t p = 0; p < s.particles; ++p) {
      ratios[cell_of(s, p)].push_back(determinant<2>(tensor_at(s, Column::deformation_gradient, p)));
    }
    double spread = 0;
    for (const auto& [cell, J] : ratios) {
      const auto [low, high] = std::minmax_element(J.begin(), J.end());
      spread = std::max(spread, *high - *low);
    }
    if (total) {
      EXPECT_GT(spread, 1e-4);
    } else {
      EXPECT_LT(spread, rounding);
    }
  }
}

double farthest_corner(const Mat<2>& r) {
  return std::max(std::hypot(r[0] + r[1], r[2] + r[3]), std::hypot(r[0] - r[1], r[2] - r[3]));
}

TEST(LargestDomain, KeepsCornersWithinReachAndShortOnesAsTheyAre) {
  constexpr double cells = 0.6;
  Simulation<2> simulation(square(method_of(Basis::cpdi), {.largest_domain = cells}));
  State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::deformation_gradient, 1)[p] = 0.2 * double(p);
  run_pass("limit_domains", s, {0, 0.1});
  int shortened = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Mat<2> F = tensor_at(s, Column::deformation_gradient, p), half{0.125, 0, 0, 0.125};
    const Mat<2> kept = product<2>(F, tensor_at(s, Column::domain, p)), whole = product<2>(F, half);
    EXPECT_LE(farthest_corner(kept), cells * 0.5 * (1 + rounding));
    EXPECT_GT(determinant<2>(kept), 0);
    if (farthest_corner(whole) > cells * 0.5) {
      ++shortened;
      EXPECT_NEAR(farthest_corner(kept), cells * 0.5, rounding);
    } else {
      for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(kept[c], whole[c], rounding);
    }
  }
  EXPECT_GT(shortened, 10);
  EXPECT_LT(shortened, 64);
}

TEST(LargestDomain, DrawsCornersToTheMiddleOfTheirDiagonal) {
  constexpr double cells = 0.6;
  Simulation<2> simulation(square(method_of(Basis::cpdi2), {.largest_domain = cells}));
  State<2>& s = simulation.state();
  const std::size_t p = 5;
  s.column(Column::corners, 6)[p] += 0.9, s.column(Column::corners, 7)[p] += 0.3;  // the corner opposite to the first
  const auto corner = [&](int c, int d) { return s.column(Column::corners, 2 * c + d)[p]; };
  const double mx = 0.5 * (corner(0, 0) + corner(3, 0)), my = 0.5 * (corner(0, 1) + corner(3, 1));
  const double other = corner(1, 0);
  run_pass("limit_domains", s, {0, 0.1});
  EXPECT_NEAR(0.5 * (corner(0, 0) + corner(3, 0)), mx, rounding);
  EXPECT_NEAR(0.5 * (corner(0, 1) + corner(3, 1)), my, rounding);
  EXPECT_NEAR(0.5 * std::hypot(corner(3, 0) - corner(0, 0), corner(3, 1) - corner(0, 1)), cells * 0.5, rounding);
  EXPECT_EQ(corner(1, 0), other);
}

TEST(SmallMass, SharesForcesOfLightNodesAndAccountsForTheRest) {
  Simulation<2> simulation(square(method_of(Basis::linear), {.small_mass = 0.5}));
  State<2>& s = simulation.state();
  const double least = 0.5 * 3 * 0.25;  // of rho0 h^2
  s.live.mark(std::size_t{3});          // with its neighbours
  s.live.merge();
  s.inertia.node(3)[0] = 0.2 * least, s.inertia.node(4)[0] = 2 * least, s.inertia.node(5)[0] = 0;
  for (const std::size_t i : {3, 4, 5}) s.force.node(i)[0] = 10, s.force.node(i)[1] = -5;
  run_pass("small_mass", s, {0, 0.1});
  EXPECT_NEAR(s.force.node(3)[0], 2, rounding);
  EXPECT_NEAR(s.force.node(3)[1], -1, rounding);
  EXPECT_EQ(s.force.node(4)[0], 10);
  EXPECT_EQ(s.force.node(5)[0], 10);  // no mass, no motion
  EXPECT_NEAR(s.ledger.impulse[0], -0.1 * 8, rounding);
  EXPECT_NEAR(s.ledger.impulse[1], 0.1 * 4, rounding);
}

TEST(SmallMass, NodesOnAPlaneAreNotLighterThanThoseInside) {
  mpm::Setup<2> setup = square(method_of(Basis::linear), {.small_mass = 0.75});
  setup.ends[0].lower = 0;  // nodes at x = 0 have half of their cells
  Simulation<2> simulation(setup);
  State<2>& s = simulation.state();
  const std::size_t on_plane = 3 + 7 * 12;
  ASSERT_EQ(s.own<Images<2>>().share(on_plane), 0.5);
  s.live.mark(on_plane);
  s.live.merge();
  const double whole = 3 * 0.25;  // rho0 h^2
  s.inertia.node(on_plane)[0] = 0.4 * whole;
  s.force.node(on_plane)[1] = 1;
  run_pass("small_mass", s, {0, 0.1});
  EXPECT_EQ(s.force.node(on_plane)[1], 1) << "80 % of what it can have";
}

// A body that fills a period is the same wherever its ends lie.
TEST(AntiLocking, DoesNotSeeThePeriodicEnds) {
  for (const AntiLocking over : {AntiLocking::cell, AntiLocking::node}) {
    std::vector<std::vector<double>> found;
    for (const int shift : {0, 1, 2}) {  // particles of the same cells, their ends elsewhere
      mpm::Setup<2> setup = square(method_of(Basis::linear), {.anti_locking = over});
      setup.ends[0] = {0.5 * shift, 2 + 0.5 * shift, true};
      for (double& x : setup.seeds.X[0]) x = x < 0.5 * shift ? x + 2 : x;
      Simulation<2> simulation(setup);
      State<2>& s = simulation.state();
      for (std::size_t p = 0; p < s.particles; ++p) {
        s.column(Column::step_volumes, 0)[p] = 1;
        s.column(Column::step_volumes, 1)[p] = 1 + 0.1 * std::sin(3.0 * static_cast<double>(p));
      }
      run_pass("average_volume", s, {0, 0.1});
      const double* scale = s.column(Column::volume_scale);
      found.emplace_back(scale, scale + s.particles);
    }
    for (std::size_t p = 0; p < found[0].size(); ++p) {
      EXPECT_NEAR(found[1][p], found[0][p], rounding);
      EXPECT_NEAR(found[2][p], found[0][p], rounding);
    }
  }
}

TEST(ArtificialViscosity, IsAPressureWhereTheVolumeShrinksAlone) {
  for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
    Simulation<2> simulation(square(method_of(Basis::bspline2, formulation), {.viscosity = {0.1, 1.5}}));
    State<2>& s = simulation.state();
    for (std::size_t p = 0; p < s.particles; ++p) {
      const double trace = p % 2 == 0 ? -4 : 4;  // L; of dF/dt, with F = 2 I, twice as much
      s.column(Column::deformation_gradient, 0)[p] = s.column(Column::deformation_gradient, 3)[p] = 2;
      const double rate = formulation == Formulation::total ? trace : trace / 2;
      s.column(Column::velocity_gradient, 0)[p] = s.column(Column::velocity_gradient, 3)[p] = rate;
    }
    run_pass("artificial_viscosity", s, {0, 0.1});
    const double h = formulation == Formulation::total ? 2 * 0.5 : 0.5;  // the cells of the former grow with the body
    const double q = 3.0 / 4 * h * (0.1 * 2 + 1.5 * h * 4) * 4;          // rho h (C1 c + C2 h |tr D|) |tr D|, J = 4
    for (std::size_t p = 0; p < s.particles; ++p) {
      for (const int c : {0, 3, 4}) EXPECT_NEAR(s.column(Column::stress, c)[p], p % 2 == 0 ? -q : 0, rounding * q);
      for (const int c : {1, 2}) EXPECT_EQ(s.column(Column::stress, c)[p], 0);
    }
  }
}

TEST(ArtificialViscosity, TakesTheThinnestWidthOfWhatShearsWithTheBody) {
  const Method total = method_of(Basis::bspline2, Formulation::total);
  for (const Method& method : {total, method_of(Basis::cpdi), method_of(Basis::cpdi2), method_of(Basis::bspline2)}) {
    Simulation<2> simulation(square(method, {.viscosity = {0.1, 0}}));
    State<2>& s = simulation.state();
    constexpr double shear = 3;
    for (std::size_t p = 0; p < s.particles; ++p) {
      s.column(Column::deformation_gradient, 1)[p] = shear;
      s.column(Column::velocity_gradient, 3)[p] = -1;  // tr D = -1, of L and of dF/dt
    }
    run_pass("artificial_viscosity", s, {0, 0.1});
    const bool of_the_grid = !method.is_total() && method.basis == Basis::bspline2;
    const double thinnest = of_the_grid ? 1 : std::sqrt(1 + shear * shear / 4) - shear / 2;
    const double q = 3.0 * 0.5 * thinnest * 0.1 * 2;
    for (std::size_t p = 0; p < s.particles; ++p) {
      EXPECT_NEAR(s.column(Column::stress, 0)[p], -q, rounding * q) << name_of(method);
    }
  }
}

TEST(RemedyContradictions, NameTheKeyAndWhatToTake) {
  const auto key = [](const Method& method, const Remedies& remedies) {
    const auto found = contradiction<2>(method, remedies.options());
    return found ? found->key : "";
  };
  Method total = method_of(Basis::bspline2, Formulation::total), stages = total, series = total;
  stages.integrator = Integrator::symplectic_rkn4;
  series.mass = Mass::series;
  EXPECT_EQ(key(total, {.anti_locking = AntiLocking::cell, .small_mass = 0.1, .viscosity = {0.1, 1}}), "");
  EXPECT_EQ(key(method_of(Basis::cpdi), {.largest_domain = 1}), "");
  EXPECT_EQ(key(stages, {.anti_locking = AntiLocking::node}), "remedies.anti_locking");
  EXPECT_EQ(key(stages, {.viscosity = {0.1, 1}}), "remedies.artificial_viscosity");
  EXPECT_EQ(key(total, {.largest_domain = 1}), "remedies.largest_domain");
  EXPECT_EQ(key(method_of(Basis::ugimp), {.largest_domain = 1}), "remedies.largest_domain");
  EXPECT_EQ(key(series, {.small_mass = 0.1}), "remedies.small_mass");
}

}  // namespace
}  // namespace assay::mpm::test_remedies
