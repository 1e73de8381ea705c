// SPDX-License-Identifier: BSD-3-Clause
// A polar motion of a body that is thick in Z. A material whose direction leaves the plane answers the plane motion
// with shears 13 and 23, and b has a third component.
#include <gtest/gtest.h>

#include "harness/exact/exact_fields.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/harness/fibre_material.hpp"

namespace assay::test_slab {
namespace {

constexpr double density = 1000, step = 2e-3;
constexpr double of_stress = 1e-11, of_force = 1e-8, matters = 1e-2;

/// Components along e_R, e_Theta, e_Z.
const Vector3 tilted = Vector3(2, 1, 2) / 3;

/// Of F at the point, whose own direction is turned by its angle: no baseline, no polar form.
Tensor piola(const Motion& motion, const Vector3& X, double t) {
  const Tensor F = motion->at(X, t).F;
  const Vector3 direction = rotation_about_z(std::atan2(X.y(), X.x())) * tilted;
  return Fibre::kirchhoff(F, direction) * F.inverse().transpose();
}

TEST(Slab, ADirectionOutOfThePlaneGivesTheBodyForceAThirdComponent) {
  const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.4, 1}};
  for (const Motion& motion : {Motion(vortex), Motion(TwistingRing{vortex, 0.05})}) {
    Path path = motion->baseline();
    path.material_direction = {tilted.x(), tilted.y(), tilted.z()};
    const Sheet sheet(*fibre_material(), path, {.tolerance = 1e-11, .end = 1});
    const auto exact = exact_polar(motion, density, std::make_shared<const Response>(sheet));
    for (const Vector3& X : {Vector3(0.7, 0.6, 0.3), Vector3(-0.3, 1.05, -2), Vector3(0.9, -0.1, 0)}) {
      const double t = 0.4;
      const auto [state, stress] = exact->at(X, t);
      Vector3 b = state.a;
      for (int d = 0; d < 3; ++d) {
        b -= central_difference([&](int k) { return piola(motion, X + k * step * Vector3::Unit(d), t); }, step).col(d) /
             density;
      }
      const Tensor P = piola(motion, X, t);
      EXPECT_LT((stress.first_piola_kirchhoff - P).norm(), of_stress * P.norm());
      EXPECT_LT((stress.body_force - b).norm(), of_force * b.norm());
      EXPECT_GT(std::abs(b.z()), matters * b.norm());
    }
  }
}

}  // namespace
}  // namespace assay::test_slab
