// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/export/force_pieces.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/export/vortex_forces.hpp"

namespace assay::drivers::test_force_pieces {
namespace {

double largest_difference(const VortexForces& vortex, const ForcePieces& pieces) {
  double largest = 0;
  for (const ForcePoint& p : force_points(vortex, 2000)) {
    const double r = std::hypot(p.x, p.y);
    const Polar b = pieces.at(r, p.t);
    const double c = r > 0 ? p.x / r : 1, s = r > 0 ? p.y / r : 0;
    largest = std::max({largest, std::abs(c * b.r - s * b.theta - p.bx), std::abs(s * b.r + c * b.theta - p.by)});
  }
  return largest / pieces.largest;
}

void expect_tolerance_kept(const std::string& text) {
  const VortexForces vortex(text);
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const ForcePieces pieces = vortex.pieces(tolerance);
    EXPECT_LE(pieces.error, tolerance);
    EXPECT_LE(largest_difference(vortex, pieces), 1.5 * tolerance);  // random points beside those that were measured
  }
}

TEST(ForcePieces, KeepTheToleranceOfAnElasticSolid) { expect_tolerance_kept(smooth_vortex); }
TEST(ForcePieces, KeepTheToleranceOfASolidWithMemory) { expect_tolerance_kept(viscous_vortex); }
TEST(ForcePieces, KeepTheToleranceWithoutInertia) { expect_tolerance_kept(static_ramp); }

// b of the paper's neo-Hookean vortex is g'^2 and g^2 times functions of R, and g times one.
TEST(ForcePieces, OfANeoHookeanSolidAreThreeProducts) {
  const ForcePieces pieces = VortexForces(smooth_vortex).pieces();
  for (const auto& piece : pieces.pieces) {
    EXPECT_EQ(piece[0].size(), 2);
    EXPECT_EQ(piece[1].size(), 1);
  }
  EXPECT_EQ(pieces.pieces.size(), 1);
  EXPECT_LT(pieces.numbers(), 90);
}

TEST(ForcePieces, BreakWhereTheRampEnds) {
  const ForcePieces pieces = VortexForces(static_ramp).pieces();
  EXPECT_NE(std::ranges::find(pieces.times, 1.0), pieces.times.end());
}

TEST(ForcePieces, AreZeroOutsideTheRing) {
  const ForcePieces pieces = VortexForces(smooth_vortex).pieces();
  for (const double R : {0.0, 0.7499, 1.2501, 1e3}) {
    EXPECT_EQ(pieces.at(R, 0.3).r, 0);
    EXPECT_EQ(pieces.at(R, 0.3).theta, 0);
  }
}

TEST(LongForcePieces, RefuseKinksInOneSentenceWithAWayOut) {
  const VortexForces plastic(R"(
motion:   {type: vortex, profile_power: 4, amplitude: {type: sine, peak: 0.1}}
material: {adapter: j2_jaumann, parameters: {E: 1.0e+3, nu: 0.3, yield_stress: 20, hardening_modulus: 200, saturation_stress: 40,
           saturation_rate: 10, kinematic_modulus: 50}, density: 1000}
)");
  try {
    plastic.pieces();
    FAIL() << "a material that yields has kinks";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("--to csv"), what.npos) << what;
    EXPECT_EQ(what.find('\n'), what.npos) << what;
  }
}

TEST(ForcePieces, AreOfThePlaneVortexAlone) {
  EXPECT_EQ(fault_of_pieces(VortexForces(smooth_vortex).scene), "");
  EXPECT_NE(fault_of_pieces(VortexForces(smooth_vortex + "frame: {spin: 1.0}\n").scene), "");
}

TEST(ForcePieces, CoefficientsReadBackAsTheyWere) {
  for (const auto& piece : VortexForces(smooth_vortex).pieces().pieces)
    for (const ForceSeries& series : piece)
      for (const ForceTerm& term : series)
        for (const auto* powers : {&term.P, &term.Q})
          for (const double c : *powers) EXPECT_EQ(std::stod(coefficient_text(c)), c);
}

}  // namespace
}  // namespace assay::drivers::test_force_pieces
