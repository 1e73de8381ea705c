// SPDX-License-Identifier: BSD-3-Clause
// Symmetry planes in space: a part of a symmetric body between planes moves as the whole body does.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "harness/exact/box_stress.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::mpm::test_images_space {
namespace {

constexpr double same_place = 1e-12;  ///< rounding [m]
constexpr int steps = 10, cells = 2;  // in 1 m: fewer than a spline reaches over
constexpr double dt = 0.004;

/// The cube from -1 to 1, which repeats, or the part of it above 0 along some axes, between planes at 0 and 1.
Setup<3> part_of_cube(const Method& method, const std::array<bool, 3>& halved) {
  Setup<3> setup;
  const double h = 1.0 / cells;
  std::array<double, 3> lower, upper{1, 1, 1};
  for (std::size_t d = 0; d < 3; ++d) {
    lower[d] = halved[d] ? 0 : -1;
    setup.ends[d] = {lower[d], 1.0, !halved[d]};
  }
  setup.method = method;
  setup.grid = grid_around<3>(lower, upper, h, 4);
  setup.seeds = cartesian_lattice<3>(lower, upper, h, {2, 2, 2}, [](const auto&) { return Fate::stepped; });
  setup.density = 1000;
  setup.material = elastic_material(1e4, 0.3);
  AxisAligned motion;
  motion.amplitude = {Amplitude::Type::sine, 0.1, 0.3};
  motion.in_space = true;
  setup.motion = motion;
  setup.exact = exact_box(motion, 1000, setup.material, {.end = 0.3});
  setup.body_force = setup.accounts = true;
  setup.evaluation = Evaluation::domain_average;
  return setup;
}

Method image_method(Basis basis, Transfer transfer, Formulation formulation, Mass mass) {
  Method method;
  method.basis = basis, method.transfer = transfer, method.formulation = formulation, method.mass = mass;
  method.terms = 3;
  return method;
}

const std::vector<Method> methods_with_planes{
    image_method(Basis::cpdi, Transfer::flip, Formulation::updated, Mass::lumped),
    image_method(Basis::cpdi2, Transfer::aflip, Formulation::updated, Mass::series),
    image_method(Basis::bspline2, Transfer::xpic, Formulation::updated, Mass::lumped),
    image_method(Basis::bspline4, Transfer::flip, Formulation::total, Mass::consistent),
    image_method(Basis::ugimp, Transfer::apic, Formulation::total, Mass::lumped),
    image_method(Basis::linear, Transfer::pic, Formulation::updated, Mass::lumped)};

void take_steps(Simulation<3>& simulation) {
  for (int k = 0; k < steps; ++k) ASSERT_FALSE(simulation.step(k * dt, dt));
}

/// On the lattice, in quarters of its spacing: equal for particles that are one.
std::array<long, 3> lattice_place(const State<3>& s, std::size_t p) {
  std::array<long, 3> found;
  for (std::size_t d = 0; d < 3; ++d) found[d] = std::lround(16 * s.column(Column::reference_position, d)[p]);
  return found;
}

/// How far the particles of a part are from where they are in the whole [m].
double apart(const State<3>& part, const State<3>& whole) {
  std::map<std::array<long, 3>, std::size_t> of_whole;
  for (std::size_t p = 0; p < whole.particles; ++p) of_whole[lattice_place(whole, p)] = p;
  EXPECT_EQ(of_whole.size(), whole.particles);
  double largest = 0;
  for (std::size_t p = 0; p < part.particles; ++p) {
    const std::size_t q = of_whole.at(lattice_place(part, p));
    for (int d = 0; d < 3; ++d) {
      const double far = part.column(Column::position, d)[p] - whole.column(Column::position, d)[q];
      largest = std::max(largest, std::abs(far));
    }
  }
  return largest;
}

const std::vector<std::array<bool, 3>> parts{{false, false, true}, {true, false, true}, {true, true, true}};

TEST(LongPlanesInSpace, CutTheSymmetricCubeWithoutATrace) {
  for (const Method& method : methods_with_planes) {
    Simulation<3> whole(part_of_cube(method, {}));
    take_steps(whole);
    for (const auto& halved : parts) {
      Simulation<3> part(part_of_cube(method, halved));
      take_steps(part);
      const auto many = static_cast<std::size_t>(1 << (halved[0] + halved[1] + halved[2]));
      ASSERT_EQ(many * part.state().particles, whole.state().particles);
      EXPECT_LT(apart(part.state(), whole.state()), same_place) << static_cast<int>(method.basis) << " " << many;
    }
  }
}

TEST(PlanesInSpace, AreInTheAccounts) {
  for (const Method& method : methods_with_planes) {
    Simulation<3> simulation(part_of_cube(method, {true, true, true}));
    const State<3>& s = simulation.state();
    const auto momentum_along = [&](int d) {
      double sum = 0;
      for (std::size_t p = 0; p < s.particles; ++p) sum += s.column(Column::mass)[p] * s.column(Column::velocity, d)[p];
      return sum;
    };
    const std::array before{momentum_along(0), momentum_along(1), momentum_along(2)};
    take_steps(simulation);
    for (std::size_t d = 0; d < 3; ++d) {
      const double gained = momentum_along(static_cast<int>(d)) - before[d];
      EXPECT_GT(std::abs(gained), 0.1) << "the planes have something to do";
      EXPECT_NEAR(gained, s.ledger.impulse[d], 1e-9 * std::abs(before[d])) << d;
    }
  }
}

// Negative control: a plane across z that leaves its momentum to the nodes on it.
TEST(PlanesInSpace, APlaneAcrossZThatIsLeftOutIsSeen) {
  auto setup = part_of_cube({}, {false, false, true});
  setup.ends[2].lower.reset();
  Simulation<3> open(setup), whole(part_of_cube({}, {}));
  take_steps(open);
  take_steps(whole);
  EXPECT_GT(apart(open.state(), whole.state()), 1e-5);
}

}  // namespace
}  // namespace assay::mpm::test_images_space
