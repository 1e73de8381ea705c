// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/twisting_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/exact/polar_average.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/gauss.hpp"
#include "tests/harness/exact/made_up_curve.hpp"
#include "tests/harness/exact/vortex_force.hpp"

namespace assay::test_twisting_ring {
namespace {

constexpr double shear_modulus = 400, lame_modulus = 600, density = 1000;

TwistingRing sample(double expansion, double peak) {
  TwistingRing ring;
  ring.expansion = expansion;
  ring.twist.amplitude = {Amplitude::Type::sine, peak, 0.8};
  ring.twist.profile_power = 4;
  return ring;
}

/// First Piola-Kirchhoff stress of (34).
Tensor neo_hookean(const Tensor& F) {
  const Tensor inverse = F.inverse().transpose();
  return shear_modulus * (F - inverse) + lame_modulus * std::log(F.determinant()) * inverse;
}

/// b in Cartesian coordinates by differences of P, of fourth order: an independent route.
Vector3 by_differences(const TwistingRing& ring, const Vector3& X, double t) {
  constexpr double h = 1e-3;
  Vector3 divergence = Vector3::Zero();
  for (int d = 0; d < 2; ++d) {
    const auto P = [&](double s) { return neo_hookean(ring.at(X + s * Vector3::Unit(d), t).F).col(d).eval(); };
    divergence += (P(-2 * h) - 8 * P(-h) + 8 * P(h) - P(2 * h)) / (12 * h);
  }
  return ring.at(X, t).a - divergence / density;
}

/// b by the ring's formulas, d tau / d R by differences along the baseline.
Vector3 by_formula(const TwistingRing& ring, const RingKinematics& now, const Vector3& X, double t) {
  constexpr double h = 1e-3;
  const double R = std::hypot(X.x(), X.y());
  const auto tau = [&](double r) { return neo_hookean(ring.ring(r, t).baseline(r)); };
  const Tensor slope = (tau(R - 2 * h) - 8 * tau(R - h) + 8 * tau(R + h) - tau(R + 2 * h)) / (12 * h);
  return now.cartesian(X, now.body_force(density, R, tau(R), slope));
}

TEST(TwistingRing, BodyForceIsThatOfTheCartesianFields) {
  const TwistingRing ring = sample(0.06, 0.7);
  for (const Vector3& X : {Vector3(0.8, 0.31, 0), Vector3(-0.53, 0.77, 0), Vector3(0.1, -1.15, 0)}) {
    for (const double t : {0.11, 0.37, 0.55}) {
      const Vector3 b = by_formula(ring, ring.ring(std::hypot(X.x(), X.y()), t), X, t);
      EXPECT_LT((b - by_differences(ring, X, t)).norm(), 1e-7 * b.norm());
    }
  }
}

/// Negative control: the Coriolis term of a_theta.
TEST(TwistingRing, AMissingCoriolisTermIsCaught) {
  const TwistingRing ring = sample(0.06, 0.7);
  const Vector3 X(0.8, 0.31, 0);
  RingKinematics now = ring.ring(std::hypot(X.x(), X.y()), 0.11);
  now.alpha_acceleration -= 2 * now.rho_rate * now.alpha_rate / now.rho;
  EXPECT_GT((by_formula(ring, now, X, 0.11) - by_differences(ring, X, 0.11)).norm(), 1e-2);
}

TEST(TwistingRing, RadialDisplacementIsFlatAtTheFacesAndOneAtTheOuter) {
  const TwistingRing ring = sample(0.06, 0.7);
  EXPECT_NEAR(ring.radial(ring.inner()).slope, 0, 1e-14);
  EXPECT_NEAR(ring.radial(ring.outer()).slope, 0, 1e-14);
  EXPECT_NEAR(ring.radial(ring.outer()).U, 1, 1e-14);
  EXPECT_NEAR(ring.at({ring.outer(), 0, 0}, 0.4).x.norm(), ring.outer() + 0.06, 1e-14);  // t = T/2
}

TEST(TwistingRing, WithoutExpansionItIsTheVortex) {
  const TwistingRing ring = sample(0, 0.7);
  for (const double t : {0.11, 0.37, 0.55}) {
    const Vector3 X(0.8, 0.31, 0);
    const double R = std::hypot(X.x(), X.y());
    const ExactState a = ring.at(X, t), b = ring.twist.at(X, t);
    EXPECT_LT((a.x - b.x).norm() + (a.v - b.v).norm() + (a.a - b.a).norm(), 1e-13);
    EXPECT_LT((a.F - b.F).norm() + (a.F_rate - b.F_rate).norm(), 1e-13);
    const RingProfile profile = ring.twist.profile(R);
    Tensor tau, slope;  // any: both make the same of them
    tau << 3, 1.5, 0, 1.5, -2, 0, 0, 0, 1;
    slope << 0.7, -0.2, 0, 0.4, 1.1, 0, 0, 0, 0.3;
    tau(0, 1) = tau(1, 0) - 2 * profile.xi * ring.twist.amplitude.at(t).value * tau(0, 0);
    const double gamma = 2 * profile.xi * ring.twist.amplitude.at(t).value;
    const double gamma_slope = 2 * ring.twist.amplitude.at(t).value;
    slope(0, 1) = slope(1, 0) - gamma * slope(0, 0) - gamma_slope * tau(0, 0);
    const Polar mine = ring.ring(R, t).body_force(density, R, tau, profile.xi_prime * slope);
    const Polar theirs = body_force(ring.twist, density, R, t, tau, slope);
    EXPECT_NEAR(mine.r, theirs.r, 1e-12 * std::abs(theirs.r));
    EXPECT_NEAR(mine.theta, theirs.theta, 1e-12 * std::abs(theirs.theta));
  }
}

TEST(TwistingRing, TurnsWhereEitherOfItsPartsDoes) {
  TwistingRing ring = sample(0.06, 0.7);
  ring.twist.amplitude.type = Amplitude::Type::one_minus_cosine;  // turns at T/2, T ..; sin(pi t/T) at T/2, 3T/2 ..
  const std::vector<double> times = ring.baseline().reversals(1.7);
  ASSERT_EQ(times.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(times[k], 0.4 * static_cast<double>(k + 1), 1e-12);
}

/// Of tau(R) at a time.
MadeUpCurve response_of_ring(const TwistingRing& ring, double t) {
  return MadeUpCurve([ring, t](double R) { return neo_hookean(ring.ring(R, t).baseline(R)); });
}

/// Mean of the pointwise force over a rectangle within the ring.
Vector3 mean_force(const TwistingRing& ring, const Rectangle& r, double t) {
  Vector3 mean = Vector3::Zero();
  for (const GaussPoint& x : gauss_points(8)) {
    for (const GaussPoint& y : gauss_points(8)) {
      const Vector3 X(r.lower[0] + 0.5 * (1 + x.at) * (r.upper[0] - r.lower[0]),
                      r.lower[1] + 0.5 * (1 + y.at) * (r.upper[1] - r.lower[1]), 0);
      mean += 0.25 * x.weight * y.weight * by_formula(ring, ring.ring(X.norm(), t), X, t);
    }
  }
  return mean;
}

TEST(TwistingRing, AveragedForceIsTheMeanOfThatAtPoints) {
  const TwistingRing ring = sample(0.06, 0.7);
  const std::vector<Rectangle> cells{
      {{0.7, 0.5}, {0.75, 0.55}}, {{-0.95, 0.2}, {-0.9, 0.25}}, {{0.1, -1.1}, {0.15, -1.05}}};
  PolarAverage average(ring, density, domains_of(cells, {ring.inner(), ring.outer()}, false), gauss_rule<8>());
  std::vector<double> x(cells.size()), y(cells.size());
  for (const double t : {0.11, 0.37}) {
    average.evaluate(response_of_ring(ring, t), t, x, y);
    for (std::size_t p = 0; p < cells.size(); ++p) {
      const Vector3 mean = mean_force(ring, cells[p], t);
      EXPECT_LT((Vector3(x[p], y[p], 0) - mean).norm(), 1e-7 * mean.norm()) << p;
    }
  }
}

}  // namespace
}  // namespace assay::test_twisting_ring
