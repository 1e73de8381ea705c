// SPDX-License-Identifier: BSD-3-Clause
// Rotation in space: slabs and cubes that turn see a defect that the square of the plane does not.
#include <gtest/gtest.h>

#include "tests/mpm/patch/planted.hpp"

namespace assay::mpm::test_turning_space {
namespace {

using SpaceDefect = DefectIn<3>;

constexpr std::size_t x = 0, y = 1, z = 2;
const Method point_linear{Basis::linear}, boxes{Basis::ugimp}, convected{Basis::cpdi},
    first{Basis::cpdi, Transfer::flip, Update::usf},
    spline{Basis::bspline2, Transfer::flip, Update::usl, Formulation::total};

constexpr auto steep_along_z = [](std::size_t d, int, int, double&, double& slope) {
  if (d == z) slope *= 1 + 1e-6;
};

/// What the square of the plane, and the slab across z with it, cannot see.
std::vector<SpaceDefect> rotation_defects() {
  return {{"23 and 13 are exchanged",
           "forces",
           true,
           [](State<3>& s, const Instant&) { swap_stress(s, 4, 5); },
           {boxes, convected, spline},
           {"slab.x", "slab.y", "tilted.axes"},
           {},
           {"slab.z"}},
          {"22 and 33 are exchanged",
           "forces",
           true,
           [](State<3>& s, const Instant&) { swap_stress(s, 1, 2); },
           {convected, spline},
           {"slab.x", "slab.y", "slab.z", "tilted.axes"}},
          {"the gradient along z is a millionth too large",
           "weights",
           true,
           [](State<3>&, const Instant&) {},
           {point_linear, boxes},
           {"slab.x", "slab.y", "tilted.axes"},
           spoil<steep_along_z, 3>,
           {"slab.z"}},
          {"L_23 and L_32 are exchanged",
           "velocity_gradient",
           false,
           [](State<3>& s, const Instant&) { transpose(s, Column::velocity_gradient, y, z); },
           {first},
           {"weights.linear", "slab.x", "tilted.axes", "tilted.strain"},
           {},
           {"slab.y", "slab.z", "tilted.stress"}},
          {"the body force has no part along z",
           "body_force",
           false,
           scale_components(Column::body_force, {2}, 0, 1),
           {boxes, convected, spline},
           {"slab.x", "slab.y", "tilted.axes"},
           {},
           {"slab.z"}},
          {"a wind blows along z",
           "grid_to_particles",
           false,
           [](State<3>& s, const Instant&) {
             for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::velocity, z)[p] += 1e-9;
           },
           {convected, spline},
           {"slab.z", "tilted.axes", "tilted.momentum"}},
          {"L_12, L_23 and L_31 are a millionth too large: only a mirror image differs",
           "velocity_gradient",
           false,
           scale_components(Column::velocity_gradient, {1, 5, 6}, 1 + 1e-6, 1),
           {first},
           {"slab.x", "slab.y", "slab.z", "tilted.axes"}},
          {"L is transposed, in all orders of the axes",
           "velocity_gradient",
           false,
           [](State<3>& s, const Instant&) {
             for (const auto& [i, j] : {std::pair{x, y}, std::pair{x, z}, std::pair{y, z}})
               transpose(s, Column::velocity_gradient, i, j);
           },
           {first},
           {"slab.x", "slab.y", "slab.z", "tilted.strain"},
           {},
           {"tilted.axes", "tilted.stress"}},
          {"there is a stress 23",
           "stress",
           false,
           [](State<3>& s, const Instant&) {
             for (std::size_t p = 0; p < s.particles; ++p) s.column(Column::stress, 5)[p] += 0.2;  // of 1000 Pa
           },
           {convected, spline},
           {"slab.x", "tilted.axes", "tilted.stress"}}};
}

TEST(TurningInSpace, CatchesDefectsOfTheThirdDimension) {
  for (const SpaceDefect& defect : rotation_defects()) expect_caught_in(defect);
}

}  // namespace
}  // namespace assay::mpm::test_turning_space
