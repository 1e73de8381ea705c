// SPDX-License-Identifier: BSD-3-Clause
#include "harness/sheet/sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/exact/polar.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_force_error {
namespace {

TEST(LongForceError, BoundsTheDifferenceToABetterSheet) {
  const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.1, 1.0}};
  const auto material = builtin_material(assay_builtin_j2_jaumann,
                                         {{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", 20}});
  const double density = 1000;
  const Sheet fine(*material, vortex.baseline(), {.tolerance = 1e-8, .end = 1});
  const Sheet coarse(*material, vortex.baseline(), {.tolerance = 1e-3, .end = 1});
  double largest = 0, scale = 0;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 20; ++j) {
      const double R = 0.75 + 0.5 * (i + 0.5) / 50, t = (j + 0.5) / 20;
      const RingProfile profile = vortex.profile(R);
      Polar b[2];
      for (const bool better : {false, true}) {
        Tensor tau, dtau;
        (better ? fine : coarse).at(profile.xi, t, tau, dtau);
        b[better] = body_force(profile, vortex.amplitude.at(t), density, R, tau, dtau);
      }
      largest = std::max(largest, std::hypot(b[0].r - b[1].r, b[0].theta - b[1].theta));
      scale = std::max(scale, std::hypot(b[1].r, b[1].theta));
    }
  }
  constexpr double between_places = 3;  // the error is stated from some places, and measured at others
  EXPECT_GT(largest / scale, 0);
  EXPECT_LT(largest / scale, between_places * force_error(vortex, density, coarse, 1));
  // five digits between what was asked of the sheets: at least two of them come through
  EXPECT_LT(force_error(vortex, density, fine, 1), 0.01 * force_error(vortex, density, coarse, 1));
}

}  // namespace
}  // namespace assay::test_force_error
