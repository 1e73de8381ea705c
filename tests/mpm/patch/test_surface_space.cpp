// SPDX-License-Identifier: BSD-3-Clause
// The patch tests of the surface in space see a traction that is wrong, at the wrong place or missing on any face, and
// a free face that bears something.
#include <gtest/gtest.h>

#include "mpm/step/surface_loads.hpp"
#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_surface_space {
namespace {

using SpaceDefect = DefectIn<3>;
using SpaceSetup = Setup<3>;  // within a test `Setup` is GoogleTest's

constexpr std::size_t x = 0, y = 1, z = 2;
const Method convected{Basis::cpdi}, corners{Basis::cpdi2}, first{Basis::cpdi, Transfer::flip, Update::usf},
    total_boxes{Basis::ugimp, Transfer::flip, Update::usl, Formulation::total},
    spline{Basis::bspline2, Transfer::flip, Update::usl, Formulation::total};

/// Something other than what the traction pass takes, from the beginning.
SpaceDefect wrong_face(const char* name, std::function<void(SpaceSetup&)> spoil_setup,
                       std::set<std::string> must_fail) {
  return {name,
          "traction",
          true,
          [](State<3>&, const Instant&) {},
          {convected, corners, first, spline, total_boxes},
          std::move(must_fail),
          [spoil_setup = std::move(spoil_setup)](State<3>& s) { spoil_setup(s.setup); }};
}

TEST(PatchedSurfaceInSpace, SeesEachFaceThatBearsNone) {
  for (const std::size_t d : {x, y, z}) {
    for (const bool upper : {false, true}) {
      expect_caught_in(wrong_face("a face is left out",
                                  [=](SpaceSetup& setup) {
                                    std::erase_if(setup.seeds.surface, [=](const auto& piece) {
                                      return upper ? piece.N_dA[d] > 0 : piece.N_dA[d] < 0;
                                    });
                                  },
                                  {"surface.traction"}));
    }
  }
}

TEST(PatchedSurfaceInSpace, SeesASinglePieceThatIsLeftOut) {
  expect_caught_in(wrong_face("a piece is left out", [](SpaceSetup& setup) { setup.seeds.surface.pop_back(); },
                              {"surface.free", "surface.traction"}));
}

TEST(PatchedSurfaceInSpace, SeesTheUndeformedArea) {
  expect_caught_in(
      wrong_face("the area is that of the undeformed face",
                 [](SpaceSetup& setup) { setup.traction->algorithm = TractionAlgorithm::undeformed_edges; },
                 {"surface.free", "surface.traction"}));
}

TEST(PatchedSurfaceInSpace, SeesAForceThatIsNotSharedByTheFourCorners) {
  expect_caught_in<3>({"one corner bears a face's force",
                       "traction",
                       true,
                       bear_on_one_corner<3>,
                       {convected, corners, first, total_boxes},
                       {"surface.free", "surface.traction"}});
}

TEST(PatchedSurfaceInSpace, SeesAFreeFaceThatBearsShear) {
  expect_caught_in<3>({"sigma_23 is not 0",
                       "forces",
                       true,
                       [](State<3>& s, const Instant&) {
                         for (std::size_t p = 0; p < s.particles; ++p)
                           s.column(Column::stress, 5)[p] += 0.01 * s.column(Column::stress, 0)[p];
                       },
                       {convected, corners, first, spline},
                       {"surface.free", "surface.traction"}});
}

}  // namespace
}  // namespace assay::mpm::test_surface_space
