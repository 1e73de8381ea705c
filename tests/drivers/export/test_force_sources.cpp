// SPDX-License-Identifier: BSD-3-Clause
// The sources, compiled or run as a user does, against the exact body force at random points.
#include "drivers/export/force_sources.hpp"

#include <gtest/gtest.h>

#include "drivers/material/tool_process.hpp"
#include "tests/drivers/export/vortex_forces.hpp"
#include "tests/support/python.hpp"

namespace assay::drivers::test_force_sources {
namespace {

bool has(const std::string& tool) { return !tool_in_path(tool).empty(); }

const char* c_program = R"(
#include <stdio.h>
void vortex_force(double, double, double, double[2]);
int main(void) {
  FILE *in = fopen("points", "r"), *out = fopen("b", "w");
  double x, y, t, b[2];
  while (fscanf(in, "%lf %lf %lf", &x, &y, &t) == 3) vortex_force(x, y, t, b), fprintf(out, "%.17g %.17g\n", b[0], b[1]);
  return fclose(out);
}
)";

const char* fortran_program = R"(
program main
  use vortex_force_module, only: vortex_force
  real(kind(1d0)) :: x, y, t, b(2)
  integer :: error
  open(10, file="points")
  open(11, file="b")
  do
    read(10, *, iostat=error) x, y, t
    if (error /= 0) exit
    call vortex_force(x, y, t, b)
    write(11, '(2es25.16e3)') b
  end do
end program main
)";

const char* python_program = R"(
import numpy as np
from vortex_force import vortex_force
points = np.loadtxt("points")
np.savetxt("b", [vortex_force(np.array([x]), np.array([y]), t)[0] for x, y, t in points], fmt="%.17g")
many = vortex_force(points[:, 0], points[:, 1], 0.3)
one = [vortex_force(p[:1], p[1:2], 0.3)[0] for p in points]
assert (many == one).all()
)";

/// Ends comments and texts, continues lines, is a mark of templates and no ASCII, and is long.
const std::string hostile_title = "*/ \"\"\" \\ & @DATA@ \xc3\xa9 " + std::string(100, 'x');

const std::array<std::string, 3> vortices{smooth_vortex, viscous_vortex, static_ramp};

void expect_language(ForceLanguage language, const std::string& program_name, const char* program,
                     const std::string& command) {
  for (const std::string& text : vortices) {
    const VortexForces vortex(text);
    const ForcePieces pieces = vortex.pieces();
    for (const auto at : {ForceCoordinates::current, ForceCoordinates::reference}) {
      const ScratchFolder scratch;
      scratch.write(force_file(language), force_source(language, pieces, at, hostile_title));
      scratch.write(program_name, program);
      expect_force(vortex, pieces, at, scratch, command);
    }
  }
}

TEST(ForceSources, InC) {
  if (!has("cc")) GTEST_SKIP() << "no cc";
  expect_language(ForceLanguage::c, "main.c", c_program,
                  "cc -std=c99 -Wall -Wextra -Werror main.c vortex_force.c -o a -lm && ./a");
}

TEST(LongForceSources, InFortran) {
  if (!has("gfortran")) GTEST_SKIP() << "no gfortran";
  expect_language(ForceLanguage::fortran, "main.f90", fortran_program,
                  "gfortran -std=f2008 -Wall -Werror vortex_force.f90 main.f90 -o a && ./a");
}

TEST(LongForceSources, InPython) {
  const std::string python = python_with("numpy");
  if (python.empty()) GTEST_SKIP() << "no numpy";
  expect_language(ForceLanguage::python, "main.py", python_program, python + " main.py");
}

/// What Abaqus's include files say, and the calls that it makes: the points of a block in one call, or one by one.
const char* include_file = "      implicit real*8(a-h,o-z)\n";

const char* explicit_program = R"(
      PROGRAM MAIN
      IMPLICIT REAL*8(A-H,O-Z)
      PARAMETER (N = 2)
      DIMENSION C(N,2), V(N,2), D(N,2,2), F(N,2)
      CHARACTER*80 S
      OPEN(10, FILE='points')
      OPEN(11, FILE='b')
   10 READ(10, *, END=20) C(1,1), C(1,2), T
      C(2,1) = C(1,2)
      C(2,2) = C(1,1)
      CALL VDLOAD(N, 2, 0D0, T, 1D0, C, V, D, 1, S, F(1,1))
      CALL VDLOAD(N, 2, 0D0, T, 1D0, C, V, D, 2, S, F(1,2))
      WRITE(11, '(2ES25.16E3)') F(1,1), F(1,2)
      GOTO 10
   20 CONTINUE
      END
)";

const char* standard_program = R"(
      PROGRAM MAIN
      IMPLICIT REAL*8(A-H,O-Z)
      DIMENSION C(3), T(2)
      CHARACTER*80 S
      OPEN(10, FILE='points')
      OPEN(11, FILE='b')
   10 READ(10, *, END=20) C(1), C(2), T(2)
      T(1) = -1
      CALL DLOAD(FX, 1, 1, T, 1, 1, 0, 0, C, 1, S)
      CALL DLOAD(FY, 1, 1, T, 1, 1, 0, 0, C, 2, S)
      WRITE(11, '(2ES25.16E3)') FX, FY
      GOTO 10
   20 CONTINUE
      END
)";

TEST(LongForceSources, AsUserRoutinesOfAbaqus) {
  if (!has("gfortran")) GTEST_SKIP() << "no gfortran";
  for (const std::string& text : vortices) {
    const VortexForces vortex(text);
    const ForcePieces pieces = vortex.pieces();
    const double density = vortex.scene.material.density;
    for (const auto routine : {AbaqusRoutine::vdload, AbaqusRoutine::dload}) {
      const ScratchFolder scratch;
      const std::string source = abaqus_force(routine, pieces, density, hostile_title);
      for (std::size_t at = 0, end = 0; at < source.size(); at = end + 1) {
        end = source.find('\n', at);
        EXPECT_LE(end - at, 72) << source.substr(at, end - at);
      }
      scratch.write("force.f", source);
      scratch.write("vaba_param.inc", include_file);
      scratch.write("aba_param.inc", include_file);
      scratch.write("main.f", routine == AbaqusRoutine::vdload ? explicit_program : standard_program);
      expect_force(vortex, pieces, ForceCoordinates::current, scratch,
                   "gfortran -Wall -Wno-unused-dummy-argument -Wno-conversion force.f main.f -o a && ./a", density);
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_force_sources
