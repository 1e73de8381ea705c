// SPDX-License-Identifier: BSD-3-Clause
// Expressions, evaluated by LAMMPS itself and by readers of the two languages whose codes are not in Debian.
#include "drivers/export/force_expressions.hpp"

#include <gtest/gtest.h>

#include "drivers/material/tool_process.hpp"
#include "tests/drivers/export/vortex_forces.hpp"
#include "tests/support/python.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_force_expressions {
namespace {

const std::string own_folder = tree_folder() + "/tests/drivers/export/";
const std::array<std::string, 3> vortices{smooth_vortex, viscous_vortex, static_ramp};

std::string words_of(const std::string& text) { return "'" + text + "'"; }

TEST(LongForceExpressions, OfNairn) {
  for (const std::string& text : vortices) {
    const VortexForces vortex(text);
    const ForcePieces pieces = vortex.pieces();
    const NairnFunctions functions = nairn_force(pieces);
    const ScratchFolder scratch;
    expect_force(vortex, pieces, ForceCoordinates::current, scratch,
                 "python3 " + own_folder + "nairn.py points " + words_of(functions.b[0]) + " " +
                     words_of(functions.b[1]) + " > b");
  }
}

/// In the ring, where alone the variables of Karamelo hold.
std::vector<ForcePoint> points_in_ring(const VortexForces& vortex) {
  std::vector<ForcePoint> points;
  for (const ForcePoint& p : force_points(vortex, 40))
    if (vortex.scene.motion->polar()->ring().holds(std::hypot(p.X, p.Y))) points.push_back(p);
  return points;
}

TEST(LongForceExpressions, OfKaramelo) {
  // Its numbers are in single precision, as are pi and the amplitude within alpha.
  constexpr double of_single_precision = 1e-6;
  for (const std::string& text : vortices)
    for (const auto at : {ForceCoordinates::current, ForceCoordinates::reference}) {
      const VortexForces vortex(text);
      const ForcePieces pieces = vortex.pieces();
      const std::vector<ForcePoint> points = points_in_ring(vortex);
      ASSERT_GT(points.size(), 10);
      const ScratchFolder scratch;
      scratch.write("input", karamelo_force(pieces, at));
      scratch.write("points", point_lines(points, at));
      expect_runs(scratch, "python3 " + own_folder + "karamelo.py input points > b");
      if (testing::Test::HasFatalFailure()) return;
      std::ifstream found(scratch / "b");
      double largest = 0, bx = 0, by = 0;
      for (const ForcePoint& p : points) {
        ASSERT_TRUE(found >> bx >> by);
        std::string rest;
        std::getline(found, rest);
        largest = std::max({largest, std::abs(bx - p.bx), std::abs(by - p.by)});
      }
      EXPECT_LE(largest, (tolerance_share * pieces.tolerance + of_single_precision) * pieces.largest) << text;
    }
}

TEST(LongForceExpressions, GiveTheVelocityAtTheBeginning) {
  const VortexForces vortex(smooth_vortex);
  const ForcePieces pieces = vortex.pieces();
  const std::vector<ForcePoint> points = points_in_ring(vortex);
  const ScratchFolder scratch;
  scratch.write("input", karamelo_force(pieces, ForceCoordinates::reference));
  scratch.write("points", point_lines(points, ForceCoordinates::reference));
  const NairnFunctions functions = nairn_force(pieces);
  expect_runs(scratch, "python3 " + own_folder + "karamelo.py input points | cut -d' ' -f3,4 > karamelo");
  expect_runs(scratch, "python3 " + own_folder + "nairn.py points " + words_of(functions.v[0]) + " " +
                           words_of(functions.v[1]) + " > nairn");
  for (const std::string code : {"karamelo", "nairn"}) {
    std::ifstream found(scratch / code);
    double vx = 0, vy = 0;
    for (const ForcePoint& p : points) {
      ASSERT_TRUE(found >> vx >> vy) << code;
      const Vector3 v = vortex.exact->state({p.X, p.Y, 0}, 0).v;
      EXPECT_NEAR(vx, v.x(), 1e-6) << code;
      EXPECT_NEAR(vy, v.y(), 1e-6) << code;
    }
  }
}

TEST(ForceExpressions, OfAQuasiStaticProblemSetNoVelocity) {
  const ForcePieces pieces = VortexForces(static_ramp).pieces();
  EXPECT_EQ(lammps_force(pieces, ForceCoordinates::current).find("v_x atom"), std::string::npos);
  EXPECT_EQ(karamelo_force(pieces, ForceCoordinates::current).find("vx0"), std::string::npos);
}

/// LAMMPS' own reader of formulas: atoms at all points, and at each time what it makes of b.
std::string lammps_input(const std::string& force, ForceCoordinates at, std::size_t atoms, double dt,
                         const std::string& steps) {
  return std::string("units si\ndimension 2\nboundary s s p\natom_style atomic\natom_modify map array\n") +
         "read_data atoms\nmass 1 1\npair_style zero 0.1\npair_coeff * *\ncomm_modify cutoff 0.2\n" +
         "fix ref all store/state 0 x y\n" + (at == ForceCoordinates::reference ? "run 0\n" : "") + force +
         "timestep " + std::to_string(dt) + "\n" + steps + "# " + std::to_string(atoms) + " atoms\n";
}

// One time for all points of an evaluation, since LAMMPS has one time for all atoms.
TEST(LongForceExpressions, OfLammps) {
  if (tool_in_path("lmp").empty()) GTEST_SKIP() << "skipped: no lmp (Debian: lammps)";
  constexpr double dt = 0.05;
  for (const std::string& text : {smooth_vortex, viscous_vortex, static_ramp})
    for (const auto at : {ForceCoordinates::current, ForceCoordinates::reference}) {
      const VortexForces vortex(text);
      const ForcePieces pieces = vortex.pieces();
      for (const int step : {0, 3, 10, 13, 20}) {
        std::vector<ForcePoint> points = force_points(vortex, 400);
        std::string atoms =
            "points\n\n400 atoms\n1 atom types\n-2 2 xlo xhi\n-2 2 ylo yhi\n-0.1 0.1 zlo zhi\n\nAtoms\n\n";
        for (std::size_t k = 0; k < points.size(); ++k) {
          ForcePoint& p = points[k];
          const ExactPoint exact = vortex.exact->at({p.X, p.Y, 0}, step * dt);
          const Vector3 b = vortex.scene.force.quasi_static ? exact.stress.static_force : exact.stress.body_force;
          p = {p.X, p.Y, step * dt, exact.state.x.x(), exact.state.x.y(), b.x(), b.y()};
          const bool current = at == ForceCoordinates::current;
          std::array<char, 120> line;
          std::snprintf(line.data(), line.size(), "%zu 1 %.17g %.17g 0\n", k + 1, current ? p.x : p.X,
                        current ? p.y : p.Y);
          atoms += line.data();
        }
        const ScratchFolder scratch;
        scratch.write("atoms", atoms);
        scratch.write("in", lammps_input(lammps_force(pieces, at), at, points.size(), dt,
                                         "reset_timestep " + std::to_string(step) +
                                             "\nrun 0\nwrite_dump all custom b id v_b_x v_b_y modify sort id format "
                                             "float %20.15g\n"));
        expect_runs(scratch, "lmp -in in -log none");
        if (testing::Test::HasFatalFailure()) return;
        std::ifstream found(scratch / "b");
        std::string line;
        while (line.rfind("ITEM: ATOMS", 0) != 0) ASSERT_TRUE(std::getline(found, line));
        double largest = 0, id = 0, bx = 0, by = 0;
        for (const ForcePoint& p : points) {
          ASSERT_TRUE(found >> id >> bx >> by);
          largest = std::max({largest, std::abs(bx - p.bx), std::abs(by - p.by)});
        }
        EXPECT_LE(largest, tolerance_share * pieces.tolerance * pieces.largest) << text << step;
      }
    }
}

}  // namespace
}  // namespace assay::drivers::test_force_expressions
