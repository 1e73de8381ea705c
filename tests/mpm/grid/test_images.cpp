// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/grid/images.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/exact/box_stress.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/mpm/grid_fields.hpp"

namespace assay::mpm::test_images {
namespace {

constexpr double image_rounding = 1e-13;

/// Five nodes of the body along x, three along y, two more on each side.
GridGeometry<2> image_grid() { return {0.5, {-2, -2}, {9, 7}}; }

std::size_t node_at(int i, int j) { return static_cast<std::size_t>(9 * (j + 2) + i + 2); }

TEST(Images, AreMirroredAtPlanesAndRepeatedAtPeriodicEnds) {
  const Images<2> mirrored(image_grid(), {AxisEnds{0.0, std::nullopt}, AxisEnds{}});
  EXPECT_EQ(mirrored.list().size(), 2u * 7u);
  for (const auto& image : mirrored.list()) {
    EXPECT_EQ(image.sign[0], -1);
    EXPECT_EQ(image.sign[1], 1);
  }
  EXPECT_EQ(mirrored.list().front().node, node_at(-2, -2));
  EXPECT_EQ(mirrored.list().front().of, node_at(2, -2));
  EXPECT_EQ(mirrored.share(node_at(0, 1)), 0.5);
  EXPECT_EQ(mirrored.share(node_at(1, 1)), 1);
  const Images<2> repeated(image_grid(), {AxisEnds{0.0, 2.0, true}, AxisEnds{}});
  EXPECT_EQ(repeated.list().size(), 5u * 7u);  // the upper end is the lower one
  for (const auto& image : repeated.list()) EXPECT_EQ(image.sign[0], 1);
  EXPECT_EQ(repeated.share(node_at(0, 1)), 1);
  EXPECT_TRUE(Images<2>(image_grid(), {}).empty());
}

TEST(Images, OfABodyThinnerThanTheMarginAreMirroredAgain) {
  const Images<2> images(image_grid(), {AxisEnds{0.0, 1.0}, AxisEnds{}});
  for (const auto& image : images.list()) {
    const auto i = static_cast<int>(image.node % 9) - 2, of = static_cast<int>(image.of % 9) - 2;
    EXPECT_TRUE(of >= 0 && of <= 2) << i;
    if (of != 1) continue;
    EXPECT_EQ(image.sign[0], i == 5 ? 1 : -1) << i;  // turned round twice; others are -1 and 3
  }
}

TEST(Images, FoldingIsAdjointToUnfolding) {
  const Images<2> images(image_grid(), {AxisEnds{0.0, 2.0}, AxisEnds{0.0, 1.0, true}});
  GridField<2> x, y;
  for (auto* field : {&x, &y}) field->allocate(image_grid().nodes());
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      x.node(i)[d] = std::sin(3.0 * static_cast<double>(i) + static_cast<double>(d));
      y.node(i)[d] = std::cos(1.7 * static_cast<double>(i * i) + static_cast<double>(d));
    }
  }
  GridField<2> unfolded = copied(x), folded = copied(y);
  images.unfold(unfolded);
  images.fold(folded);
  GridField<2> own = copied(unfolded);  // of the body's own nodes
  for (const auto& image : images.list()) own.node(image.node)[0] = own.node(image.node)[1] = 0;
  double left = 0, right = 0;
  for (std::size_t i = 0; i < x.nodes(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      left += unfolded.node(i)[d] * y.node(i)[d];
      right += own.node(i)[d] * folded.node(i)[d];
    }
  }
  EXPECT_NEAR(left, right, image_rounding * 10);
}

/// The box from -1 to 1, of which the planes at 0 and 1 make the quarter in question.
Setup<2> box_setup(const Method& method, double lower, bool periodic, int across) {
  Setup<2> setup;
  const double h = 1.0 / across;
  setup.method = method;
  setup.grid = grid_around<2>({lower, lower}, {1, 1}, h, 4);
  setup.seeds = cartesian_lattice<2>({lower, lower}, {1, 1}, h, {2, 2}, [](const auto&) { return Fate::stepped; });
  setup.density = 1000;
  setup.material = elastic_material(1e4, 0.3);
  AxisAligned motion;
  motion.amplitude = {Amplitude::Type::sine, 0.1, 0.3};
  setup.motion = motion;
  setup.exact = exact_box(motion, 1000, setup.material, {.end = 0.3});
  setup.body_force = setup.accounts = true;
  setup.evaluation = Evaluation::domain_average;
  for (AxisEnds& ends : setup.ends) ends = {lower, 1.0, periodic};
  return setup;
}

struct ImageMethod {
  std::string name;
  Method method;
};

std::vector<ImageMethod> image_methods() {
  const auto made = [](Basis basis, Transfer transfer, Formulation formulation, Mass mass, Update update) {
    Method method;
    method.basis = basis, method.transfer = transfer, method.formulation = formulation, method.mass = mass;
    method.update = update, method.terms = 3;
    return method;
  };
  using enum Basis;
  using enum Transfer;
  using enum Formulation;
  Method stages = made(bspline3, flip, total, Mass::series, Update::usl);
  stages.integrator = Integrator::symplectic_rkn4;
  return {{"cpdi_flip_usf", made(cpdi, flip, updated, Mass::lumped, Update::usf)},
          {"cpdi2_aflip_series", made(cpdi2, aflip, updated, Mass::series, Update::usl)},
          {"ugimp_apic_musl", made(ugimp, apic, total, Mass::lumped, Update::musl)},
          {"bspline2_xpic", made(bspline2, xpic, updated, Mass::lumped, Update::usl)},
          {"bspline2_fmpm", made(bspline2, fmpm, total, Mass::lumped, Update::usl)},
          {"bspline3_stages", stages},
          {"bspline4_consistent", made(bspline4, flip, total, Mass::consistent, Update::usl)},
          {"linear_pic", made(linear, pic, updated, Mass::lumped, Update::usl)}};
}

class Planes : public testing::TestWithParam<ImageMethod> {};

constexpr int image_steps = 12;
constexpr double image_dt = 0.004;

TEST_P(Planes, AndTheirImagesAreAmongTheLiveNodes) {
  for (const double lower : {0.0, -1.0}) {
    const mpm::Setup<2> setup = box_setup(GetParam().method, lower, lower < 0, 8);
    Simulation<2> simulation(setup);
    ASSERT_FALSE(simulation.step(0, image_dt));
    EXPECT_EQ(nodes_reached(setup), simulation.state().live.count());
  }
}

/// Particles of the whole box whose reference positions are those of the quarter do as these.
TEST_P(Planes, CutTheSymmetricBodyWithoutATrace) {
  Simulation<2> quarter(box_setup(GetParam().method, 0, false, 8)), whole(box_setup(GetParam().method, -1, true, 8));
  for (int k = 0; k < image_steps; ++k) {
    ASSERT_FALSE(quarter.step(k * image_dt, image_dt));
    ASSERT_FALSE(whole.step(k * image_dt, image_dt));
  }
  const State<2>&a = quarter.state(), &b = whole.state();
  std::size_t found = 0;
  for (std::size_t p = 0; p < a.particles; ++p) {
    for (std::size_t q = 0; q < b.particles; ++q) {
      bool same = true;
      for (int d = 0; d < 2; ++d) {
        same = same && std::abs(a.column(Column::reference_position, d)[p] -
                                b.column(Column::reference_position, d)[q]) < image_rounding;
      }
      if (!same) continue;
      ++found;
      for (int d = 0; d < 2; ++d) {
        EXPECT_NEAR(a.column(Column::position, d)[p], b.column(Column::position, d)[q], 10 * image_rounding);
        EXPECT_NEAR(a.column(Column::velocity, d)[p], b.column(Column::velocity, d)[q], 1e-11);
      }
    }
  }
  EXPECT_EQ(found, a.particles);
}

// What the planes give to the body's momentum is booked, and the energy is that of a body left alone.
TEST_P(Planes, AreInTheAccounts) {
  Simulation<2> simulation(box_setup(GetParam().method, 0, false, 8));
  const State<2>& s = simulation.state();
  const auto momentum = [&](int d) {
    double sum = 0;
    for (std::size_t p = 0; p < s.particles; ++p) sum += s.column(Column::mass)[p] * s.column(Column::velocity, d)[p];
    return sum;
  };
  const double before[] = {momentum(0), momentum(1)};
  for (int k = 0; k < image_steps; ++k) ASSERT_FALSE(simulation.step(k * image_dt, image_dt));
  for (int d = 0; d < 2; ++d) {
    const double gained = momentum(d) - before[d];
    EXPECT_GT(std::abs(gained), 1) << "the planes have something to do";
    EXPECT_NEAR(gained, s.ledger.impulse[static_cast<std::size_t>(d)], 1e-9 * std::abs(before[d])) << d;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Planes, testing::ValuesIn(image_methods()),
                         [](const auto& c) { return c.param.name; });

// Negative control: a plane that leaves its momentum to the nodes on it.
TEST(Images, APlaneThatIsLeftOutIsSeen) {
  auto setup = box_setup({}, 0, false, 8);
  setup.ends[0].lower.reset();
  Simulation<2> open(setup), closed(box_setup({}, 0, false, 8));
  for (int k = 0; k < image_steps; ++k) {
    ASSERT_FALSE(open.step(k * image_dt, image_dt));
    ASSERT_FALSE(closed.step(k * image_dt, image_dt));
  }
  double farthest = 0;
  for (std::size_t p = 0; p < open.state().particles; ++p) {
    farthest = std::max(farthest, std::abs(open.state().column(Column::position, 0)[p] -
                                           closed.state().column(Column::position, 0)[p]));
  }
  EXPECT_GT(farthest, 1e-4);
}

}  // namespace
}  // namespace assay::mpm::test_images
