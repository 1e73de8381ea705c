// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "harness/exact/exact_fields.hpp"
#include "harness/exact/polar.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/exact/vortex_force.hpp"

namespace assay::test_body_force {
namespace {

using std::numbers::pi;

/// b at a reference point and a time, by any formula.
using BodyForce = std::function<Vector3(const Vector3& X, double t)>;

struct Case {
  Vortex vortex;
  double E, nu, density;
};

std::vector<Case> cases() {
  return {{Vortex{}, 1e3, 0.3, 1000},
          {Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.6, 1.4}}, 2.5e4, 0.41, 730},
          {Vortex{0.4, 1.1, 4, {Amplitude::Type::one_minus_cosine, 0.9, 0.8}}, 5e3, 0.1, 2000}};
}

Response closed_form(const Case& c) {
  return Response(*ClosedForm::of(elastic_material(c.E, c.nu), c.vortex.baseline()));
}

Response sheet(const Case& c) { return Response(Sheet(*elastic_material(c.E, c.nu), c.vortex.baseline(), {.end = 1})); }

double radius(const Vector3& X) { return std::hypot(X.x(), X.y()); }

double current_angle(const Vortex& vortex, const Vector3& X, double t) {
  return std::atan2(X.y(), X.x()) + vortex.amplitude.at(t).value * vortex.profile(radius(X)).h;
}

Vector3 cartesian(const Polar& b, double theta) { return rotation_about_z(theta) * Vector3(b.r, b.theta, 0); }

BodyForce ours(const Case& c, const Response& response) {
  return [&](const Vector3& X, double t) {
    Tensor tau, slope;
    response.at(c.vortex.profile(radius(X)).xi, t, tau, slope);
    return cartesian(body_force(c.vortex, c.density, radius(X), t, tau, slope), current_angle(c.vortex, X, t));
  };
}

/// T(X, t) of the neo-Hookean material (34) directly from F(X, t): no baseline, no polar form.
Tensor piola_at(const Case& c, const Vector3& X, double t) {
  const Tensor F = c.vortex.at(X, t).F, inverse_transpose = F.inverse().transpose();
  const double mu = c.E / (2 * (1 + c.nu)), lambda = c.E * c.nu / ((1 + c.nu) * (1 - 2 * c.nu));
  return mu * (F - inverse_transpose) + lambda * std::log(F.determinant()) * inverse_transpose;
}

/// DIV(T) (2) in Cartesian components by eighth-order central differences of the full two-dimensional field.
Vector3 divergence_by_differences(const Case& c, const Vector3& X, double t) {
  const double step = 2e-3 * (c.vortex.outer - c.vortex.inner);
  Vector3 divergence = Vector3::Zero();
  for (int j = 0; j < 2; ++j) {
    divergence +=
        central_difference([&](int k) { return piola_at(c, X + k * step * Vector3::Unit(j), t); }, step).col(j);
  }
  return divergence;
}

/// Largest |DIV(T) + rho0 (b - a)| (1) over the ring and time, relative to the largest rho0 |b|.
double imbalance(const Case& c, const BodyForce& b) {
  double residual = 0, scale = 0;
  for (const double s : {0.12, 0.33, 0.5, 0.66, 0.91}) {
    for (const double angle : {0.2, 1.7, 3.9, 5.5}) {
      for (const double t : {0.04, 0.31, 0.48, 0.83}) {
        const double R = c.vortex.inner + s * (c.vortex.outer - c.vortex.inner);
        const Vector3 X(R * std::cos(angle), R * std::sin(angle), 0);
        const Vector3 force = c.density * b(X, t);
        residual =
            std::max(residual, (divergence_by_differences(c, X, t) + force - c.density * c.vortex.at(X, t).a).norm());
        scale = std::max(scale, force.norm());
      }
    }
  }
  return residual / scale;
}

/// Differences of eighth order with this step leave about 1e-10 of the largest value; planted errors leave 1e-2 up.
constexpr double balanced = 1e-8;
constexpr double caught = 1e-2;

TEST(BodyForce, BalancesMomentumAgainstABruteForceDivergence) {
  for (const Case& c : cases()) {
    EXPECT_LT(imbalance(c, ours(c, closed_form(c))), balanced);
    EXPECT_LT(imbalance(c, ours(c, sheet(c))), balanced);
  }
}

TEST(BodyForce, SheetAndClosedFormAgree) {
  for (const Case& c : cases()) {
    const Response table = sheet(c), exact = closed_form(c);
    const BodyForce a = ours(c, table), b = ours(c, exact);
    for (const double R : {0.76, 0.9, 1.04}) {
      for (const double t : {0.1, 0.5, 0.9}) {
        const Vector3 X(R * std::cos(1.0), R * std::sin(1.0), 0);
        EXPECT_LT((a(X, t) - b(X, t)).norm(), 1e-10 * (1 + b(X, t).norm()));
      }
    }
  }
}

/// (35) of the paper for its own parameters; `squared`: with (15-32R+16R^2) squared in (35b), as it must be.
BodyForce papers_closed_form(bool squared) {
  return [squared](const Vector3& X, double t) {
    const double mu = 1e3 / 2.6, rho = 1000, R = radius(X), q = 15 - 32 * R + 16 * R * R;
    const double s = std::sin(pi * t), c = std::cos(pi * t), d = R - 1;
    const double h_prime = -64 * d + 1024 * d * d * d;
    const Polar b{
        -pi * pi * R * q * q * q * q * c * c + R * mu * s * s * h_prime * h_prime / rho,
        -(64 * mu * (-45 + 188 * R - 240 * R * R + 96 * R * R * R) + rho * pi * pi * R * (squared ? q * q : q)) * s /
            rho};
    return cartesian(b, current_angle(Vortex{}, X, t));
  };
}

TEST(BodyForce, IsThePapersClosedFormWithItsErratum) {
  const Case c = cases()[0];
  const Response table = sheet(c);
  const BodyForce b = ours(c, table), exact = papers_closed_form(true);
  for (double R = 0.76; R < 1.25; R += 0.03) {
    for (double t = 0.02; t < 1; t += 0.09) {
      const Vector3 X(R * std::cos(2 * R), R * std::sin(2 * R), 0);
      EXPECT_LT((b(X, t) - exact(X, t)).norm(), 1e-11 * (1 + exact(X, t).norm()));
    }
  }
}

TEST(BodyForce, PiolaAndCauchyFormsOfTheDivergenceAgree) {
  for (const Case& c : cases()) {
    const Response table = sheet(c);
    for (const double s : {0.03, 0.2, 0.5, 0.7, 0.97}) {
      for (const double t : {0.13, 0.4, 0.71}) {
        const double R = c.vortex.inner + s * (c.vortex.outer - c.vortex.inner);
        Tensor tau, slope;
        table.at(c.vortex.profile(R).xi, t, tau, slope);
        const auto profile = c.vortex.profile(R);
        const double g = c.vortex.amplitude.at(t).value;
        const Polar a = divergence_piola(profile, g, R, tau, slope), b = divergence_cauchy(profile, g, R, tau, slope);
        const double scale = tau.norm() + slope.norm() * std::abs(c.vortex.profile(R).xi_prime);
        EXPECT_NEAR(a.r, b.r, 1e-12 * scale);
        EXPECT_NEAR(a.theta, b.theta, 1e-12 * scale);
      }
    }
  }
}

/// An error of interpolation in one component does not set the two forms apart; a stress that is not symmetric does.
TEST(BodyForce, OnlyTheErrorOfATableIsMadeSymmetric) {
  const Case c = cases()[0];
  const double R = 0.9, t = 0.4, g = c.vortex.amplitude.at(t).value;
  const RingProfile profile = c.vortex.profile(R);
  for (const auto& [share, apart] : {std::pair{1e-8, false}, std::pair{1e-2, true}}) {
    Tensor tau, slope;
    closed_form(c).at(profile.xi, t, tau, slope);
    tau(1, 0) *= 1 + share;
    const Polar a = divergence_piola(profile, g, R, tau, slope), b = divergence_cauchy(profile, g, R, tau, slope);
    const double difference = std::hypot(a.r - b.r, a.theta - b.theta) / std::hypot(a.r, a.theta);
    if (apart) {
      EXPECT_GT(difference, 1e-4);
    } else {
      EXPECT_LT(difference, 1e-12);
    }
  }
}

TEST(BodyForceNegativeControl, Printed33IsCaught) {
  const Case c = cases()[0];
  const Response exact = closed_form(c);
  const BodyForce printed = [&](const Vector3& X, double t) {
    const double R = radius(X), theta = current_angle(c.vortex, X, t);
    const double inertia = R * c.vortex.amplitude.at(t).acceleration * c.vortex.profile(R).h;
    return Vector3(ours(c, exact)(X, t) + cartesian({0, -2 * inertia}, theta));  // - R g'' h instead of + R g'' h
  };
  EXPECT_GT(imbalance(c, printed), caught);
}

TEST(BodyForceNegativeControl, Printed35bIsCaught) {
  EXPECT_LT(imbalance(cases()[0], papers_closed_form(true)), balanced);
  EXPECT_GT(imbalance(cases()[0], papers_closed_form(false)), caught);
}

TEST(BodyForceNegativeControl, RotationAppliedTwiceIsCaught) {
  const Case c = cases()[0];
  const Response exact = closed_form(c);
  const BodyForce twice = [&](const Vector3& X, double t) {
    const double alpha = c.vortex.amplitude.at(t).value * c.vortex.profile(radius(X)).h;
    return Vector3(rotation_about_z(alpha) * ours(c, exact)(X, t));  // at the current angle plus alpha
  };
  EXPECT_GT(imbalance(c, twice), caught);
}

TEST(BodyForce, JumpsOnTheEdgesOfTheRing) {
  const Case c = cases()[0];
  const double mu = 1e3 / 2.6, t = 0.5;
  const Response exact = closed_form(c);
  for (const auto& [R, factor] : {std::pair{0.75, -96.0}, std::pair{1.25, -160.0}}) {
    Tensor tau, slope;
    exact.at(c.vortex.profile(R).xi, t, tau, slope);
    EXPECT_NEAR(body_force(c.vortex, c.density, R, t, tau, slope).theta, factor * mu / c.density, 1e-9);
  }
  EXPECT_EQ(body_force(c.vortex, c.density, 1.3, t, Tensor::Zero(), Tensor::Zero()).theta, 0);
}

TEST(BodyForceField, GivesEveryPointItsOwnForceOncePerRadius) {
  const Case c = cases()[1];
  const Response table = sheet(c);
  const std::vector<double> X{0.8, -0.8, 0.3, 0.3, 0.0, 1.0, 2.0}, Y{0.3, 0.3, -0.8, 0.8, 0.0, 0.1, 1.0};
  EXPECT_EQ(RingPoints(X, Y).radius.size(), 4u);
  const auto exact = exact_polar(c.vortex, c.density, std::make_shared<const Response>(sheet(c)));
  const auto field = exact->instant({X, Y}, {.force = true});
  std::vector<double> bx(X.size()), by(X.size());
  field->set_time(0.4);
  field->body_force(bx, by);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const Vector3 point(X[i], Y[i], 0);
    const Vector3 expected = radius(point) > 0 ? ours(c, table)(point, 0.4) : Vector3::Zero();
    EXPECT_NEAR(bx[i], expected.x(), 1e-12 * (1 + expected.norm()));
    EXPECT_NEAR(by[i], expected.y(), 1e-12 * (1 + expected.norm()));
  }
}

}  // namespace
}  // namespace assay::test_body_force
