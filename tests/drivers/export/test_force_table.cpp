// SPDX-License-Identifier: BSD-3-Clause
// Tables over time, and the routines in other languages that read them.
#include "drivers/export/force_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "drivers/format/npz.hpp"
#include "drivers/material/tool_process.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/exact/places.hpp"
#include "tests/drivers/export/exported.hpp"
#include "tests/support/python.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_force_table {
namespace {

/// A cubic in time is met to rounding everywhere, the ends included.
TEST(ForceTables, InterpolateCubicsExactly) {
  const auto cubic = [](double t, std::span<double> out) {
    out[0] = 1 + t - 2 * t * t + 3 * t * t * t, out[1] = -t * t * t;
  };
  const ForceTable table = table_over_time(cubic, 1, 2, 2, 1, 1);
  EXPECT_LT(table.error, 1e-14);
  for (const double t : {0.0, 0.01, 0.7, 1.99, 2.0}) {
    double exact[2];
    cubic(t, exact);
    EXPECT_NEAR(table.at(t)[0], exact[0], 1e-12) << t;
    EXPECT_NEAR(table.at(t)[1], exact[1], 1e-12) << t;
  }
  EXPECT_EQ(table.at(-1), table.at(0));
  EXPECT_EQ(table.at(3), table.at(2));
}

/// The error that a table says is no smaller than the one that is found at many times.
TEST(ForceTables, SayTheirError) {
  const auto wave = [](double t, std::span<double> out) { out[0] = std::sin(11 * t); };
  const ForceTable table = table_over_time(wave, 1, 1, 1, 1, 1);
  double worst = 0;
  for (int k = 0; k <= 5000; ++k)
    worst = std::max(worst, std::abs(table.at(k / 5000.0)[0] - std::sin(11 * k / 5000.0)));
  EXPECT_LE(table.error, interpolation_error);
  EXPECT_GT(table.error, 0.02 * interpolation_error) << "many more times than needed";
  EXPECT_LT(worst, 1.05 * table.error * table.largest);
}

TEST(ForceTables, OfKinksSaySo) {
  const auto jump = [](double t, std::span<double> out) { out[0] = t < 1 / std::numbers::pi ? 0 : 1; };
  const ForceTable table = table_over_time(jump, 1, 1, 1, 1, 1);
  EXPECT_GT(table.error, interpolation_error);
  EXPECT_LT(table.times, 150u) << "more times do not help";
  EXPECT_NE(table_words(table, "N").find("kinks"), std::string::npos);
}

TEST(ForceTables, OfTheVortexMeetTheExactForce) {
  for (const bool quasi_static : {false, true}) {
    ExportOptions options = export_options("csv", ".15");
    options.quasi_static = quasi_static;
    const ExportedProblem problem = exported(options);
    const ForceTable table = body_force_table(problem, problem.grids[0]);
    EXPECT_LE(table.error, interpolation_error);
    for (const double t : {0.037, 0.31, 0.5, 0.93}) {
      const std::vector<double> found = table.at(t);
      for (std::size_t k = 0; k < problem.grids[0].size(); ++k) {
        const ExactPoint exact = problem.exact->at(problem.grids[0].X[k], t);
        const Vector3 b = quasi_static ? exact.stress.static_force : exact.stress.body_force;
        EXPECT_NEAR(found[2 * k], b.x(), 1.01 * table.error * table.largest);
        EXPECT_NEAR(found[2 * k + 1], b.y(), 1.01 * table.error * table.largest);
      }
    }
  }
}

/// rho0 b of all particles and the tractions on all faces make the momentum of a body whose F is the same everywhere.
TEST(ForceTables, OfTractionsBalanceTheBody) {
  const ExportedProblem problem =
      exported(export_options("csv", ".125", tree_folder() + "/configs/motions/rotating_stretch.yaml"));
  const ExportedGrid& grid = problem.grids[0];
  const std::vector<SurfaceFace> faces = surface_faces(grid, problem.dimension);
  const ForceTable force = body_force_table(problem, grid), traction = traction_table(problem, faces);
  const double t = 0.37 * problem.end;
  const std::vector<double> b = force.at(t), p = traction.at(t);
  const auto n = static_cast<std::size_t>(problem.dimension);
  Tensor of_faces = Tensor::Zero(), of_stress = Tensor::Zero();
  for (std::size_t k = 0; k < faces.size(); ++k) {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        of_faces(i, j) += faces[k].area * p[n * k + static_cast<std::size_t>(i)] * faces[k].X[j];
  }
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const ExactPoint exact = problem.exact->at(grid.X[k], t);
    of_stress += grid.volume[k] * exact.stress.first_piola_kirchhoff;
    EXPECT_NEAR(b[n * k], exact.state.a.x(), 2 * interpolation_error * force.largest);
  }
  // the integral of P N X^T over the surface is that of P over the body, where DIV P = 0
  EXPECT_GT(of_stress.cwiseAbs().maxCoeff(), 10);
  for (const int c : {0, 1, 3, 4})
    EXPECT_NEAR(of_faces(c / 3, c % 3), of_stress(c / 3, c % 3), 2 * interpolation_error * traction.largest) << c;
}

/// Forces on all nodes have no sum without inertia: what acts on the free body is in balance.
TEST(ForceTables, OfNodalLoadsAreInBalanceWithoutInertia) {
  ExportOptions options =
      export_options("nodal-loads", ".25", tree_folder() + "/configs/motions/homogeneous_shear.yaml");
  options.quasi_static = true;
  const ExportedProblem problem = exported(options);
  const ForceTable table = nodal_load_table(problem, problem.grids[0]);
  const std::vector<double> force = table.at(0.6 * problem.end);
  double x = 0, y = 0;
  for (std::size_t k = 0; k < table.points; ++k) x += force[table.dimension * k], y += force[table.dimension * k + 1];
  EXPECT_GT(table.largest, 1);
  EXPECT_NEAR(x, 0, 1e-9 * table.largest);
  EXPECT_NEAR(y, 0, 1e-9 * table.largest);
}

/// A table in a file, times between its own, and what the routines of the templates print of it.
class TableRoutines : public testing::Test {
 protected:
  void SetUp() override {
    const auto wave = [](double t, std::span<double> out) {
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = std::sin(5 * t + static_cast<double>(k));
    };
    table_ = table_over_time(wave, 3, 2, 1.5, 1, 1);
    scratch_.write("force.bin", bytes_of_table(table_));
    for (const auto& [name, text] : table_routines()) scratch_.write(name, text);
  }
  void run(const std::string& command) const {
    ASSERT_EQ(std::system(("cd '" + (scratch_ / "") + "' && (" + command + ") >said 2>&1").c_str()), 0)
        << bytes_of(scratch_ / "said");
  }
  /// said: t and the six components of all points, for each time.
  void expect_values() const {
    std::istringstream said(bytes_of(scratch_ / "said"));
    for (const double t : times) {
      double found = 0;
      said >> found;
      EXPECT_NEAR(found, t, 1e-12);
      for (const double value : table_.at(t)) {
        said >> found;
        EXPECT_NEAR(found, value, rounding) << t;
      }
    }
    EXPECT_TRUE(said) << bytes_of(scratch_ / "said");
  }
  static constexpr double times[] = {-0.5, 0, 0.01, 0.7, 1.49, 1.5, 2};
  static constexpr double rounding = 1e-14;
  ForceTable table_;
  ScratchFolder scratch_;
};
using LongTableRoutines = TableRoutines;

TEST_F(TableRoutines, InC) {
  if (tool_in_path("cc").empty()) GTEST_SKIP() << "no cc";
  scratch_.write("main.c", R"(#include <stdio.h>
#include "force_table.h"
int main(void) {
  const double times[] = {-0.5, 0, 0.01, 0.7, 1.49, 1.5, 2};
  double b[6];
  force_table table;
  int i, k;
  if (force_table_read(&table, "none.bin") == 0 || force_table_read(&table, "main.c") == 0) return 1;
  if (force_table_read(&table, "force.bin") != 0 || table.points != 3 || table.components != 2) return 2;
  for (i = 0; i < 7; ++i) {
    force_table_at(&table, times[i], b);
    printf("%.17g", times[i]);
    for (k = 0; k < 6; ++k) printf(" %.17g", b[k]);
    printf("\n");
  }
  force_table_free(&table);
  return 0;
})");
  run("cc -std=c99 -Wall -Wextra -Werror -pedantic -O1 main.c force_table.c -o in_c && ./in_c");
  expect_values();
}

TEST_F(TableRoutines, InFortran) {
  if (tool_in_path("gfortran").empty()) GTEST_SKIP() << "no gfortran";
  scratch_.write("main.f90", R"(program main
  use force_tables
  use, intrinsic :: iso_fortran_env, only: real64
  implicit none
  real(real64), parameter :: times(7) = [-0.5_real64, 0.0_real64, 0.01_real64, 0.7_real64, 1.49_real64, 1.5_real64, &
                                         2.0_real64]
  type(force_table) :: table
  real(real64) :: b(2, 3)
  integer :: i, status
  call table%read('none.bin', status)
  if (status == 0) stop 1
  call table%read('main.f90', status)
  if (status == 0) stop 2
  call table%read('force.bin', status)
  if (status /= 0 .or. table%points /= 3 .or. table%components /= 2) stop 3
  do i = 1, 7
    call table%at(times(i), b)
    print '(7es26.17)', times(i), b
  end do
end program
)");
  run("gfortran -std=f2008 -Wall -Wextra -Werror -pedantic -O1 force_table.f90 main.f90 -o in_fortran && ./in_fortran");
  expect_values();
}

TEST_F(LongTableRoutines, InPython) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << "no numpy";
  scratch_.write("main.py", R"(import numpy as np
from force_table import ForceTable
table = ForceTable("force.bin")
assert len(table.times) == len(table.values) and abs(table.times[-1] - 1.5) < 1e-14
out = np.empty((3, 2))
for t in (-0.5, 0, 0.01, 0.7, 1.49, 1.5, 2):
    b = table(t, out=out)
    assert b is out and (table(t) == out).all()
    print(repr(float(t)), *map(repr, map(float, b.ravel())))
try:
    ForceTable("main.py")
except ValueError:
    pass
else:
    raise SystemExit("no error")
)");
  run("export PYTHONDONTWRITEBYTECODE=1; " + python + " main.py");
  expect_values();
  run("export PYTHONDONTWRITEBYTECODE=1; " + python + " force_table.py force.bin 0.7");
  EXPECT_EQ(bytes_of(scratch_ / "said").substr(0, 15), "t,id,x,y\n0.7,1,");
}

TEST(Npz, IsWhatNumPyReads) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << "no numpy";
  const ScratchFolder scratch;
  const std::vector<double> t{0, 0.5}, b{1, 2, 3, 4, 5, 6};
  scratch.write("a.npz", npz_bytes({{"t", {2}, t}, {"b", {2, 1, 3}, b}}));
  const std::string program =
      "import numpy as np; a = np.load(\"a.npz\"); assert sorted(a) == [\"b\", \"t\"] and a[\"t\"].tolist() == [0, .5] "
      "and a[\"b\"].tolist() == [[[1, 2, 3]], [[4, 5, 6]]]";
  EXPECT_EQ(std::system(("cd '" + (scratch / "") + "' && " + python + " -c '" + program + "'").c_str()), 0);
}

}  // namespace
}  // namespace assay::drivers::test_force_table
