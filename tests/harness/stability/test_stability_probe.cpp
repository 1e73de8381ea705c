// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/stability_probe.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/stability/stability_screen.hpp"
#include "harness/stability/wave_speed.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_stability_probe {
namespace {

/// The Jaumann rate for deformations of the plane alone: it fails in others.
const assay_material* plane_table() {
  static const assay_material table = [] {
    assay_material t = *jaumann_table();
    t.flags |= ASSAY_IN_PLANE;
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* factor, char* message) {
      jaumann_detail::update(self, step, n, state0, state1, cauchy, status, factor, message);
      for (std::size_t p = 0; p < n; ++p) {
        for (int c = 0; c < 9; ++c) {
          const bool moved = component(jaumann_detail::tensor_at(step->F1, n, p), c) != 0;
          if (!is_in_plane(c) && moved) status[p] = ASSAY_FAILED;
        }
      }
    };
    return t;
  }();
  return &table;
}

/// In simple shear the principal stresses that differ the most lie in the plane, and so do the wave that is lost first
/// and its normal.
TEST(StabilityProbe, WavesInThePlaneOfAMaterialThatKnowsNoOthers) {
  const Path path = Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 1, 1.0}}.baseline();
  const Material solid(jaumann_table(), {}), plane(plane_table(), {});
  const StabilityProbe all(solid, path, 1), some(plane, path, 1);
  constexpr double differences = 1e-6;
  EXPECT_NEAR(some.scale(), all.scale(), differences * all.scale());
  EXPECT_NEAR(some.at_rest().value, all.at_rest().value, differences * all.scale());
  const StabilityScreen expected = screen_stability(solid, path, 1), found = screen_stability(plane, path, 1);
  EXPECT_EQ(found.verdict, StabilityScreen::Verdict::unstable);
  EXPECT_NEAR(found.safe_fraction, expected.safe_fraction, 1e-3);
  EXPECT_NEAR(std::abs(2 * found.xi * std::sin(std::numbers::pi * found.t)), std::numbers::pi / 3, 2e-2);
}

TEST(StabilityProbe, ADifferenceByWhatAMaterialDoesNotTakeIsZero) {
  const Material solid(jaumann_table(), {}), plane(plane_table(), {});
  const Tensor I = Tensor::Identity();
  const std::vector<double> rest(9, 0.0);
  const TangentModulus all = probe_tangent_modulus(solid, 0, 1, I, rest);
  const TangentModulus some = probe_tangent_modulus(plane, 0, 1, I, rest);
  for (int c = 0; c < 9; ++c) {
    EXPECT_EQ(some.col(c), is_in_plane(c) ? TangentModulus(all).col(c).eval() : TangentModulus::Zero().col(c).eval());
  }
  EXPECT_NEAR(fastest_wave(some, I, 1000), fastest_wave(all, I, 1000), 1e-9);
}

}  // namespace
}  // namespace assay::test_stability_probe
