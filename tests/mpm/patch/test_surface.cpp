// SPDX-License-Identifier: BSD-3-Clause
// The patch tests of the surface see a traction that is wrong, at the wrong place or missing, and a free face that
// bears something.
#include "mpm/step/surface_loads.hpp"
#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_surface {
namespace {

using LoadedSetup = Setup<2>;  // within a test `Setup` is GoogleTest's

const std::set<std::string> both_surfaces{"surface.free", "surface.traction"};

Method surface_method(Basis basis, Formulation formulation = Formulation::updated, Update update = Update::usl) {
  Method method{basis, Transfer::flip, update};
  method.formulation = formulation;
  return method;
}

const std::vector<Method> surface_methods{
    surface_method(Basis::cpdi), surface_method(Basis::cpdi, Formulation::updated, Update::usf),
    surface_method(Basis::cpdi2, Formulation::updated, Update::musl), surface_method(Basis::ugimp, Formulation::total),
    surface_method(Basis::bspline2, Formulation::total)};

/// Something other than what the traction pass takes, from the beginning.
Defect wrong_traction(const char* name, std::function<void(LoadedSetup&)> spoil) {
  return {name,
          "traction",
          true,
          [](State<2>&, const Instant&) {},
          surface_methods,
          both_surfaces,
          [spoil = std::move(spoil)](State<2>& s) { spoil(s.setup); }};
}

TEST(PatchedSurface, SeesATractionThatIsOnePercentTooLarge) {
  expect_caught(wrong_traction("tractions are 1 % too large", [](LoadedSetup& setup) {
    for (SurfaceEdge& edge : setup.seeds.surface) {
      for (double& component : edge.N_dA) component *= 1.01;
    }
  }));
}

TEST(PatchedSurface, SeesAFaceThatBearsNone) {
  expect_caught(wrong_traction("a face is left out", [](LoadedSetup& setup) {
    std::erase_if(setup.seeds.surface, [](const SurfaceEdge& edge) { return edge.N_dA[0] > 0; });
  }));
}

TEST(PatchedSurface, SeesASingleEdgeThatIsLeftOut) {
  expect_caught(wrong_traction("an edge is left out", [](LoadedSetup& setup) { setup.seeds.surface.pop_back(); }));
}

TEST(PatchedSurface, SeesTractionsAtTheCentresOfParticles) {
  expect_caught(wrong_traction("tractions act at the particles",
                               [](LoadedSetup& setup) { setup.traction->algorithm = TractionAlgorithm::particles; }));
}

TEST(PatchedSurface, SeesTheUndeformedLength) {
  expect_caught(wrong_traction("the length is that of the undeformed edge", [](LoadedSetup& setup) {
    setup.traction->algorithm = TractionAlgorithm::undeformed_edges;
  }));
}

TEST(PatchedSurface, SeesAForceThatIsNotHalvedBetweenTheCorners) {
  expect_caught({"one corner bears an edge's force",
                 "traction",
                 true,
                 bear_on_one_corner<2>,
                 {surface_methods.begin(), surface_methods.end() - 1},  // B-splines have no corners
                 both_surfaces});
}

TEST(PatchedSurface, SeesAFreeFaceThatBearsSomething) {
  expect_caught({"sigma_22 is not 0", "forces", true,
                 [](State<2>& s, const Instant&) {
                   for (std::size_t p = 0; p < s.particles; ++p)
                     s.column(Column::stress, 3)[p] += 0.01 * s.column(Column::stress, 0)[p];
                 },
                 surface_methods, both_surfaces});
}

}  // namespace
}  // namespace assay::mpm::test_surface
