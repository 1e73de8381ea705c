// SPDX-License-Identifier: BSD-3-Clause
// Particles on lines between cells, where the linear basis has slopes at nodes without mass.
#include "mpm/step/passes.hpp"

#include <algorithm>
#include <limits>
#include <memory>

#include "tests/mpm/vortex_setup.hpp"

namespace assay::mpm::test_massless_nodes {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The block of tests/mpm/vortex_setup.hpp with particles on lines across the first `axes` of its axes: one of two lies
/// on a line, and the last of a row on one with nothing beyond.
template <int Dim>
mpm::Setup<Dim> block_on_lines(const Method& method, int axes) {
  mpm::Setup<Dim> setup = block_setup<Dim>(method);
  setup.grid.first.fill(-5);
  setup.grid.count.fill(11);
  for (std::size_t d = 0; d < static_cast<std::size_t>(axes); ++d) {
    for (double& X : setup.seeds.X[d]) X = std::round((X + 0.025) / 0.05) * 0.05;
  }
  return setup;
}

template <int Dim>
void expect_rigid_motion(const Method& method, int axes) {
  Simulation<Dim> simulation(block_on_lines<Dim>(method, axes));
  State<Dim>& s = simulation.state();
  const double v[3] = {0.7, -0.3, 0.4};
  for (int d = 0; d < Dim; ++d) std::fill_n(s.column(Column::velocity, d), s.particles, v[d]);
  ASSERT_FALSE(simulation.step(0, 0.01));
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int c = 0; c < Dim * Dim; ++c) {
      EXPECT_NEAR(s.column(Column::deformation_gradient, c)[p], c % (Dim + 1) == 0 ? 1 : 0, 20 * epsilon) << p;
    }
    for (int d = 0; d < Dim; ++d) EXPECT_NEAR(s.column(Column::velocity, d)[p], v[d], 20 * epsilon) << p;
  }
}

/// Each particle with a deformation and a stress of its own: what it gives to nodes without mass belongs to the body.
template <int Dim>
void expect_momentum_kept(const Method& method, int axes) {
  Simulation<Dim> simulation(block_on_lines<Dim>(method, axes));
  State<Dim>& s = simulation.state();
  for (int d = 0; d < Dim; ++d) std::fill_n(s.column(Column::velocity, d), s.particles, 0.7 - 0.3 * d);
  const auto vary = [&](Column column, int components, double by) {
    for (int c = 0; c < components; ++c) {
      for (std::size_t p = 0; p < s.particles; ++p) {
        s.column(column, c)[p] += by * std::sin(1.7 * static_cast<double>(p) + c);
      }
    }
  };
  vary(Column::deformation_gradient, Dim * Dim, 0.1);
  vary(Column::stress, stress_components<Dim>, 1e3);
  const Vec<Dim> before = momentum(s);
  const double scale = momentum_scale(s);
  ASSERT_FALSE(simulation.step(0, 1e-3));
  double gained = 0;  // of the particles: there were forces
  for (std::size_t p = 0; p < s.particles; ++p) gained += std::abs(s.column(Column::velocity, 0)[p] - 0.7);
  EXPECT_GT(gained, 1e-5 * static_cast<double>(s.particles));
  const Vec<Dim> after = momentum(s);
  for (std::size_t d = 0; d < Dim; ++d) EXPECT_NEAR(after[d], before[d], 100 * epsilon * scale);
}

struct OnLines : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Method, OnLines, testing::ValuesIn(all_methods()), way_name);

TEST_P(OnLines, RigidMotionIsCarriedExactly) {
  for (const int axes : {1, 2}) expect_rigid_motion<2>(GetParam(), axes);
}

TEST_P(OnLines, RigidMotionInSpaceIsCarriedExactly) {
  for (const int axes : {1, 2, 3}) expect_rigid_motion<3>(GetParam(), axes);
}

TEST_P(OnLines, MomentumIsKept) {
  for (const int axes : {1, 2}) expect_momentum_kept<2>(GetParam(), axes);
}

TEST_P(OnLines, MomentumInSpaceIsKept) {
  for (const int axes : {1, 2, 3}) expect_momentum_kept<3>(GetParam(), axes);
}

/// Particles at these nodes of a grid of h = 1 whose first node is (-2, -2), each with its velocity along x.
struct Placed {
  double X, Y, velocity;
};
std::unique_ptr<Simulation<2>> particles_at(const std::vector<Placed>& placed) {
  mpm::Setup<2> setup;
  setup.method = {Basis::linear, Transfer::flip, Update::usl};
  setup.grid = {1, {-2, -2}, {9, 9}};
  setup.seeds.half_size.fill(0.25);
  setup.density = 1000;
  setup.material = elastic_material();
  for (const Placed& each : placed) {
    setup.seeds.X[0].push_back(each.X);
    setup.seeds.X[1].push_back(each.Y);
  }
  auto simulation = std::make_unique<Simulation<2>>(std::move(setup));
  for (std::size_t p = 0; p < placed.size(); ++p) {
    simulation->state().column(Column::velocity, 0)[p] = placed[p].velocity;
  }
  return simulation;
}

double speed_at(const State<2>& s, int i, int j) {
  return s.motion.node(static_cast<std::size_t>((j + 2) * s.setup.grid.count[0] + i + 2))[0];
}

TEST(Massless, MoveAsTheMeanOfTheirNeighboursAlongTheAxes) {
  const auto simulation = particles_at({{0, 0, 1}, {2, 0, 4}, {2, 0, 4}});
  ASSERT_FALSE(simulation->step(0, 1e-6));
  const State<2>& s = simulation->state();
  EXPECT_NEAR(speed_at(s, 1, 0), 3, 1e-14);  // of masses 1 and 2
  EXPECT_NEAR(speed_at(s, 0, 1), 1, 1e-14);
  EXPECT_NEAR(speed_at(s, 3, 0), 4, 1e-14);
  EXPECT_NEAR(speed_at(s, 0, 0), 1, 1e-14);
}

TEST(Massless, AcrossACellTakeWhatItsOtherCornerHas) {
  const auto simulation = particles_at({{0, 0, 1}, {2, 2, 3}});
  ASSERT_FALSE(simulation->step(0, 1e-6));
  EXPECT_NEAR(speed_at(simulation->state(), 1, 1), 2, 1e-14);
  EXPECT_NEAR(speed_at(simulation->state(), 3, 3), 3, 1e-14);
}

TEST(Massless, MassOfRoundingCountsAsNone) {
  const double off = 1e-13;  // of a cell: what a flight leaves
  const auto simulation = particles_at({{off, -off, 1}, {2 - off, off, 1}});
  State<2>& s = simulation->state();
  s.column(Column::stress, 0)[0] = 1;  // would throw a node of 1e-10 kg away
  ASSERT_FALSE(simulation->step(0, 1e-3));
  for (std::size_t i = 0; i < s.motion.nodes(); ++i) EXPECT_LT(std::abs(s.motion.node(i)[2]), 0.01);
}

/// Far from any mass they stand still, as the whole grid around the body does.
TEST(Massless, WithoutSuchNeighboursStandStill) {
  const auto simulation = particles_at({{0, 0, 1}});
  ASSERT_FALSE(simulation->step(0, 1e-6));
  EXPECT_EQ(speed_at(simulation->state(), 2, 0), 0);
  EXPECT_EQ(speed_at(simulation->state(), 2, 2), 0);
}

/// Along the axes a body goes through a periodic end: its particles lie on lines at 0 and 1, which are one.
TEST(Massless, FindTheirNeighboursThroughPeriodicEnds) {
  for (const Update update : {Update::usl, Update::usf, Update::musl}) {
    mpm::Setup<2> setup;
    setup.method = {Basis::linear, Transfer::flip, update};
    setup.grid = {0.25, {-4, -4}, {13, 13}};
    setup.seeds.half_size.fill(0.0625);
    setup.seeds.X = {{{0.0, 0.0, 0.75}, {0.125, 0.375, 0.25}}};
    setup.density = 1000;
    setup.material = elastic_material();
    setup.ends[0] = {0.0, 1.0, true};
    Simulation<2> simulation(setup);
    State<2>& s = simulation.state();
    const std::vector<double> v{1, 1, 1};
    std::copy(v.begin(), v.end(), s.column(Column::velocity, 0));
    for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::stress, 0)[p] = 0;
    ASSERT_FALSE(simulation.step(0, 1e-3));
    for (std::size_t p = 0; p < s.particles; ++p) {
      EXPECT_NEAR(s.column(Column::velocity, 0)[p], 1, 20 * epsilon) << p;
      for (int c = 0; c < 4; ++c) {
        EXPECT_NEAR(s.column(Column::deformation_gradient, c)[p], c % 3 == 0 ? 1 : 0, 20 * epsilon) << p;
      }
    }
  }
}

/// There the node on the edge alone has a weight, as of linear functions.
template <int Dim>
void expect_rigid_motion_from_edge(const Method& method, bool upper) {
  mpm::Setup<Dim> setup = block_setup<Dim>(method);
  setup.grid.first.fill(upper ? -5 : 0);
  setup.grid.count.fill(6);
  for (std::size_t d = 1; d < Dim; ++d) {
    for (double& X : setup.seeds.X[d]) X += upper ? -0.2 : 0.2;
  }
  setup.seeds.X[0].assign(setup.seeds.X[0].size(), 0);
  Simulation<Dim> simulation(std::move(setup));
  State<Dim>& s = simulation.state();
  std::fill_n(s.column(Column::velocity, 0), s.particles, upper ? -1.0 : 1.0);
  ASSERT_FALSE(simulation.step(0, 0.01));
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int c = 0; c < Dim * Dim; ++c) {
      EXPECT_NEAR(s.column(Column::deformation_gradient, c)[p], c % (Dim + 1) == 0 ? 1 : 0, 20 * epsilon);
    }
  }
}

TEST(Massless, AreWhatSplinesHaveOnTheEdgeOfTheGrid) {
  for (const Basis basis : {Basis::bspline2, Basis::bspline3, Basis::bspline4}) {
    for (const Formulation formulation : {Formulation::updated, Formulation::total}) {
      for (const bool upper : {false, true}) {
        const Method method{basis, Transfer::flip, Update::usl, formulation};
        expect_rigid_motion_from_edge<2>(method, upper);
        expect_rigid_motion_from_edge<3>(method, upper);
      }
    }
  }
}

TEST(Massless, ArePassesOfTheLinearBasisAlone) {
  for (const Method& method : all_methods()) {
    const auto passes = compose(block_setup<2>(method));
    const auto count = std::count_if(passes.begin(), passes.end(),
                                     [](const auto& pass) { return pass.name.find("massless") != std::string::npos; });
    const int times = method.update == Update::usl ? 2 : 4;
    EXPECT_EQ(count, method.basis == Basis::linear ? times : 0) << name_of(method);
  }
}

}  // namespace
}  // namespace assay::mpm::test_massless_nodes
