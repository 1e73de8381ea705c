// SPDX-License-Identifier: BSD-3-Clause
// The body force over boxes, as eval writes it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/format/csv.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_eval_boxes {
namespace {

const std::string ball =
    "motion: {type: vortex3d, axis: [1, 2, 3], amplitude: {peak: 0.5}}\n"
    "material: {adapter: mooney_rivlin, parameters: {c10: 120, c01: 60, bulk_modulus: 900}, density: 1000}\n";
const std::string plane =
    "motion: {type: vortex, amplitude: {peak: 0.5}}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1000, nu: 0.3}, density: 1000}\n";

CsvTable evaluated(const std::string& scene, const std::string& points) {
  const ScratchFolder scratch;
  EvalOptions options;
  options.scene = scratch.write("scene.yaml", scene);
  options.points = scratch.write("points.csv", points);
  options.out = scratch / "out.csv";
  EXPECT_EQ(eval(options), 0);
  const std::string text = bytes_of(options.out);
  std::vector<std::string> names;
  std::string name;
  for (const char c : text.substr(0, text.find('\n') + 1)) {
    if (c == ',' || c == '\n')
      names.push_back(std::move(name)), name.clear();
    else
      name += c;
  }
  return read_csv(text, options.out, names);
}

double value(const CsvTable& table, const std::string& name, std::size_t row = 0) { return (*table.column(name))[row]; }

TEST(EvalBoxes, MeansTendToTheValueAtThePoint) {
  const CsvTable at = evaluated(ball, "X,Y,Z,t\n0.3,0.2,-0.1,0.4\n");
  double before = 0;
  for (const double half : {0.04, 0.02}) {
    const std::string h = "," + std::to_string(half);
    const CsvTable over = evaluated(ball, "X,Y,Z,t,HX,HY,HZ\n0.3,0.2,-0.1,0.4" + h + h + h + "\n");
    EXPECT_NEAR(value(over, "V"), 8 * half * half * half, 1e-15);
    double error = 0;
    for (const char* b : {"bx", "by", "bz"}) error = std::max(error, std::abs(value(over, b) - value(at, b)));
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.3);  // second order
    }
    before = error;
  }
}

/// Eight boxes fill the one: their forces and moments add up.
TEST(EvalBoxes, ForcesAndMomentsAddUp) {
  std::string points = "X,Y,Z,t,HX,HY,HZ\n0.4,0.2,0.1,0.3,0.1,0.1,0.1\n";
  for (const double x : {0.35, 0.45}) {
    for (const double y : {0.15, 0.25}) {
      for (const double z : {0.05, 0.15})
        points += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + ",0.3,0.05,0.05,0.05\n";
    }
  }
  const CsvTable table = evaluated(ball, points);
  constexpr double of_rule = 5e-3;  // two Gauss points along the edge of the large box, of 0.2 m
  for (const char* b : {"bx", "by", "bz"}) {
    double sum = 0, size = 0;
    for (std::size_t row = 1; row < 9; ++row)
      sum += value(table, b, row) * value(table, "V", row),
          size += std::abs(value(table, b, row) * value(table, "V", row));
    EXPECT_NEAR(sum, value(table, b) * value(table, "V"), of_rule * size) << b;
  }
  for (const char* m : {"mx", "my", "mz"}) {
    double sum = 0, size = 0;
    for (std::size_t row = 1; row < 9; ++row) sum += value(table, m, row), size += std::abs(value(table, m, row));
    EXPECT_NEAR(sum, value(table, m), of_rule * size) << m;
  }
}

/// The whole ring in one square: at rest in its angular momentum's mean, its stress has no total.
TEST(EvalBoxes, APlaneSceneHasRectangles) {
  const CsvTable table = evaluated(plane, "X,Y,t,HX,HY\n1,0,0.5,0.02,0.02\n0,0,0.5,0.1,0.1\n");
  EXPECT_EQ(table.column("mx"), nullptr);
  EXPECT_NE(table.column("mz"), nullptr);
  EXPECT_NEAR(value(table, "V"), 0.0016, 1e-15);
  EXPECT_NEAR(value(table, "bx", 1), 0, 1e-15);  // inside the hole of the ring
  const CsvTable at = evaluated(plane, "X,Y,t\n1,0,0.5\n");
  EXPECT_NEAR(value(table, "bx"), value(at, "bx"), 0.05 * std::abs(value(at, "bx")));
}

/// One box around the whole ball: its inertia alone, rho0 g'' integral of h R^2 dV = (4 pi/3) B(5/2, 5) about the axis.
TEST(EvalBoxes, ABoxLargerThanTheMotionIsDivided) {
  const CsvTable table = evaluated(ball, "X,Y,Z,t,HX,HY,HZ\n0,0,0,0.3,1.1,1.2,1.05\n");
  const double pi = std::numbers::pi, g = -0.5 * pi * pi * std::sin(0.3 * pi);
  const double moment = 1000 * g * 4 * pi / 3 * std::exp(std::lgamma(2.5) + std::lgamma(5) - std::lgamma(7.5));
  const double of_axis[] = {1 / std::sqrt(14.0), 2 / std::sqrt(14.0), 3 / std::sqrt(14.0)};
  constexpr double of_rule = 1e-4;
  EXPECT_NEAR(value(table, "mx"), moment * of_axis[0], of_rule * std::abs(moment));
  EXPECT_NEAR(value(table, "my"), moment * of_axis[1], of_rule * std::abs(moment));
  EXPECT_NEAR(value(table, "mz"), moment * of_axis[2], of_rule * std::abs(moment));
  EXPECT_NEAR(value(table, "bx"), 0, of_rule);
}

/// Where two vortices touch, the box feels the sum of what each alone exerts: their stresses do not overlap.
TEST(EvalBoxes, TwoVorticesInABoxAddUp) {
  const auto of = [](const std::string& vortices) {
    const std::string scene = "motion: {type: vortex3d, vortices: [" + vortices + "], amplitude: {peak: 1}}\n" +
                              ball.substr(ball.find("material"));
    return evaluated(scene, "X,Y,Z,t,HX,HY,HZ\n0,0.05,0.03,0.4,0.02,0.02,0.02\n0,0,0,0.4,0.04,0.04,0.04\n");
  };
  for (const std::string power : {"2", "3"}) {
    const std::string left = "{radius: 0.4, profile_power: " + power + ", axis: [1, 2, 3], center: [-0.4, 0, 0]}",
                      right = "{radius: 0.4, profile_power: " + power + ", axis: [3, -1, 1], center: [0.4, 0, 0]}";
    const CsvTable both = of(left + ", " + right), one = of(left), other = of(right);
    for (const char* b : {"bx", "by", "bz"}) {
      for (std::size_t row = 0; row < 2; ++row)
        EXPECT_NEAR(value(both, b, row), value(one, b, row) + value(other, b, row), 2e-3) << power << b << row;
    }
  }
}

TEST(EvalBoxes, EdgesThatAreMissingOrTooManyAreRefused) {
  const auto refused = [](const std::string& scene, const std::string& points) {
    try {
      evaluated(scene, points);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto expect = [&](const std::string& found, const std::string& part) {
    EXPECT_NE(found.find(part), found.npos) << found;
  };
  expect(refused(ball, "X,Y,Z,t,HX,HY\n0,0,0,0.1,0.1,0.1\n"), "boxes in three dimensions need HZ");
  expect(refused(ball, "X,Y,Z,t,NX,NY\n0,0,0,0.1,0,1\n"), "NX: normals in three dimensions need NZ");
  expect(refused(plane, "X,Y,t,HX,HY,HZ\n1,0,0.1,0.1,0.1,0.1\n"), "boxes of a plane scene have HX and HY alone");
  expect(refused(ball, "X,Y,Z,t,HX,HY,HZ\n0,0,0,0.1,1e-9,0.1,0.1\n"), "half edges must be at least");
  expect(refused(ball, "X,Y,Z,t,HX,HY,HZ\n1e8,0,0,0.1,0.1,0.1,0.1\n"), "half edges must be at least");
  expect(refused(ball, "X,Y,Z,t,HX,HY,HZ\n0,0,0,0.1,1e3,1e3,1e3\n"), "the box is too large for a mean");
  expect(refused(plane, "X,Y,t,HX\n1,0,0.1,0.1\n"), "HX and HY only come together");
  expect(refused(plane, "X,Y,t,HX,HY\n1,0,0.1,0.1,0\n"), "must be greater than 0");
  expect(refused("motion: {type: twisting_ring, expansion: 0.05}\n" + plane.substr(plane.find("material")),
                 "X,Y,t,HX,HY\n0.8,0,0.1,0.1,0.1\n"),
         "its box reaches out of the ring");
}

}  // namespace
}  // namespace assay::drivers::test_eval_boxes
