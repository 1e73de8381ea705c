// SPDX-License-Identifier: BSD-3-Clause
// The body force without inertia, as eval writes it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drivers/format/csv.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_eval_static {
namespace {

const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
const std::vector<std::string> sets{"force.quasi_static=true"};

CsvTable evaluated(const std::string& points, const std::vector<std::string>& with,
                   const std::vector<std::string>& more = {}) {
  const ScratchFolder scratch;
  EvalOptions options;
  options.scene = scene;
  options.points = scratch.write("points.csv", points);
  options.out = scratch / "out.csv";
  options.sets = with;
  EXPECT_EQ(eval(options), 0);
  std::vector<std::string> columns{"X",   "Y",   "t",   "x",   "y",   "vx",  "vy",  "ax",  "ay",
                                   "F11", "F12", "F21", "F22", "F33", "P11", "P12", "P21", "P22",
                                   "P33", "s11", "s12", "s22", "s33", "bx",  "by"};
  columns.insert(columns.end(), more.begin(), more.end());
  return read_csv(bytes_of(options.out), options.out, columns);
}

double value(const CsvTable& table, const std::string& name, std::size_t row = 0) { return (*table.column(name))[row]; }

/// (35) without its terms of inertia.
TEST(EvalStatic, IsTheClosedFormWithoutInertia) {
  const double mu = 1e3 / 2.6, rho = 1000, pi = std::numbers::pi;
  const std::string points = "X,Y,t\n0.8,0.3,0.2\n-0.4,0.95,0.5\n0.1,-1.2,0.9\n0.2,0.1,0.4\n";
  const CsvTable still = evaluated(points, sets), moving = evaluated(points, {});
  for (std::size_t i = 0; i < 3; ++i) {
    const double X = value(still, "X", i), Y = value(still, "Y", i), s = std::sin(pi * value(still, "t", i));
    const double R = std::hypot(X, Y), d = R - 1, q = 15 - 32 * R + 16 * R * R;
    const double h1 = -64 * d + 1024 * d * d * d, h2 = -64 + 3072 * d * d;
    const double br = R * mu * s * s * h1 * h1 / rho, bt = -mu * s * (3 * h1 + R * h2) / rho;
    const double theta = std::atan2(Y, X) + s * q * q, scale = std::hypot(br, bt);
    EXPECT_NEAR(value(still, "bx", i), br * std::cos(theta) - bt * std::sin(theta), 1e-11 * scale);
    EXPECT_NEAR(value(still, "by", i), br * std::sin(theta) + bt * std::cos(theta), 1e-11 * scale);
    EXPECT_GT(std::abs(value(still, "bx", i) - value(moving, "bx", i)), 1e-3 * scale);  // the control
    for (const char* same : {"x", "vx", "ax", "F12", "P11", "s12"})
      EXPECT_EQ(value(still, same, i), value(moving, same, i)) << same;
  }
  EXPECT_EQ(value(still, "bx", 3), 0);  // inside the hole of the ring
}

/// Over a box it lacks the mean of the acceleration.
TEST(EvalStatic, SoItIsOverBoxes) {
  const std::string points = "X,Y,t,HX,HY\n0.8,0.3,0.2,0.001,0.001\n";
  const CsvTable still = evaluated(points, sets, {"V", "mz"}), moving = evaluated(points, {}, {"V", "mz"});
  for (const char* d : {"x", "y"}) {
    const double a = value(still, std::string("a") + d);
    EXPECT_NEAR(value(moving, std::string("b") + d) - value(still, std::string("b") + d), a, 1e-4 * std::abs(a));
  }
  EXPECT_EQ(value(still, "V"), value(moving, "V"));
  EXPECT_NE(value(still, "mz"), value(moving, "mz"));
}

TEST(EvalStatic, NoRunIsWithoutInertia) {
  try {
    assemble(read_scene(scene, sets), 1);
    FAIL() << "it runs";
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("force.quasi_static: leaves the inertia out, which every run has"), said.npos) << said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_eval_static
