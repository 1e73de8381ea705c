// SPDX-License-Identifier: BSD-3-Clause
// The body force from the sheet of every model against the divergence of the full two-dimensional field of the first
// Piola-Kirchhoff stress: at each point of a stencil the model's equations are integrated along the exact F(X, t).
#include <gtest/gtest.h>

#include <cstdio>

#include "harness/motion/kinds/vortex.hpp"
#include "tests/adapters/models/sheet_checks.hpp"

namespace assay::model_tests::test_body_forces {
namespace {

constexpr double density = 1000;

/// P(X, t) from F(X, t) of the motion with all its rotation; the material's direction is E_R.
Tensor piola_at(const ModelCase& c, const Vortex& vortex, const Vector3& X, double t) {
  const double R = X.norm();
  const Vector3 E_R = X / R, E_Theta(-E_R.y(), E_R.x(), 0);
  const RingProfile profile = vortex.profile(R);
  const auto F = [&](double s) { return vortex.at(X, s).F; };
  const auto F_rate = [&](double s) {
    const AmplitudeValue g = vortex.amplitude.at(s);
    const Tensor Q = rotation_about_z(g.value * profile.h), spin = g.rate * profile.h * cross_matrix(Vector3::UnitZ());
    return Tensor(spin * F(s) + R * g.rate * profile.h_prime * Q * E_Theta * E_R.transpose());
  };
  return piola(c.stress({F, F_rate, t, turns_before(vortex.amplitude, t), E_R}), F(t));
}

/// b = a - DIV P / rho0 by differences of eighth order in X and Y.
Vector3 force_by_differences(const ModelCase& c, const Vortex& vortex, const Vector3& X, double t, double step) {
  Vector3 divergence = Vector3::Zero();
  for (int j = 0; j < 2; ++j) {
    const auto P = [&](int k) { return piola_at(c, vortex, X + k * step * Vector3::Unit(j), t); };
    divergence += central_difference(P, step).col(j);
  }
  return vortex.at(X, t).a - divergence / density;
}

Vector3 force_of(const Vortex& vortex, const Vector3& X, double t, const Tensor& tau, const Tensor& dtau) {
  const double R = X.norm(), Theta = std::atan2(X.y(), X.x());
  const Polar b = body_force(vortex, density, R, t, tau, dtau);
  return rotation_about_z(Theta + vortex.amplitude.at(t).value * vortex.profile(R).h) * Vector3(b.r, b.theta, 0);
}

/// A pseudo-random point of the ring and of time, whose stencil stays inside the ring and away from kinks.
struct Place {
  Vector3 X;
  double t, step;
};

std::vector<Place> places_in(const Setting& setting, const Sheet& sheet, int count, double first_time = 0.02) {
  constexpr double away = 0.01, reach = 4, longest = 1.5e-3, share = 0.04;
  const Vortex& vortex = setting.vortex;
  const Interval range = vortex.xi_range();
  std::mt19937 random(7);
  const auto uniform = [&] { return random() / 4294967296.0; };
  std::vector<Place> places;
  while (static_cast<int>(places.size()) < count) {
    const double R = vortex.inner + uniform() * (vortex.outer - vortex.inner), angle = 6.28 * uniform();
    const double t = setting.end * (first_time + (1 - first_time) * uniform());
    const RingProfile p = vortex.profile(R);
    const double distance = distance_from_kinks(sheet, range, p.xi, t);
    const double step = std::min(longest, share * distance / std::abs(p.xi_prime));
    if (distance < away * range.width()) continue;
    if (R - reach * step < vortex.inner + 0.005 || R + reach * step > vortex.outer - 0.005) continue;
    places.push_back({R * Vector3(std::cos(angle), std::sin(angle), 0), t, step});
  }
  return places;
}

/// Differences relative to the largest |b|.
struct ForceDifference {
  double sheet = 0, forms = 0, naive = 0;
};

/// (21) of the paper: d tau / d eps along the history of the point, times g.
Tensor naive_slope(const Sheet& sheet, const Vortex& vortex, double xi, double t) {
  constexpr double step = 1e-4;
  const auto tau_at = [&](int k) {
    Tensor tau, dtau;
    sheet.at(xi, t + k * step, tau, dtau);
    return tau;
  };
  const AmplitudeValue g = vortex.amplitude.at(t);
  return central_difference(tau_at, step) * (g.value / (xi * g.rate));
}

ForceDifference force_difference(const ModelCase& c, const Setting& setting, const Sheet& sheet,
                                 const std::vector<Place>& places) {
  ForceDifference d;
  double scale = 0, divergence_scale = 0;
  for (const Place& place : places) {
    const double R = place.X.norm(), g = setting.vortex.amplitude.at(place.t).value;
    const RingProfile profile = setting.vortex.profile(R);
    Tensor tau, dtau;
    sheet.at(profile.xi, place.t, tau, dtau);
    const Vector3 exact = force_by_differences(c, setting.vortex, place.X, place.t, place.step);
    const Tensor naive = naive_slope(sheet, setting.vortex, profile.xi, place.t);
    const Polar a = divergence_piola(profile, g, R, tau, dtau), b = divergence_cauchy(profile, g, R, tau, dtau);
    d.sheet = std::max(d.sheet, (force_of(setting.vortex, place.X, place.t, tau, dtau) - exact).norm());
    d.naive = std::max(d.naive, (force_of(setting.vortex, place.X, place.t, tau, naive) - exact).norm());
    d.forms = std::max(d.forms, std::hypot(a.r - b.r, a.theta - b.theta));
    scale = std::max(scale, exact.norm());
    divergence_scale = std::max(divergence_scale, std::hypot(a.r, a.theta));
  }
  return {d.sheet / scale, d.forms / divergence_scale, d.naive / scale};
}

void expect_balance(const ModelCase& c, Amplitude::Type type, int points) {
  const Setting setting = setting_of(c, type);
  const Sheet sheet = sheet_of(c, setting);
  const ForceDifference d = force_difference(c, setting, sheet, places_in(setting, sheet, points));
  std::printf("%-28s end %g: b %.1e  Piola - Cauchy %.1e  naive %.1e\n", c.name.c_str(), setting.end, d.sheet, d.forms,
              d.naive);
  std::fflush(stdout);
  EXPECT_LT(d.sheet, c.smooth() ? 1e-8 : 1e-7);
  EXPECT_LT(d.forms, 1e-12);
}

class BodyForceOfEveryModel : public testing::TestWithParam<ModelCase> {};

TEST_P(BodyForceOfEveryModel, BalancesTheDivergenceOfTheFullField) {
  expect_balance(GetParam(), Amplitude::Type::sine, 4);
  expect_balance(GetParam(), Amplitude::Type::one_minus_cosine, 4);
}

INSTANTIATE_TEST_SUITE_P(Models, BodyForceOfEveryModel, testing::ValuesIn(quick_model_cases()),
                         [](const auto& instance) { return instance.param.name; });

class LongBodyForceOfEveryModel : public testing::TestWithParam<ModelCase> {};

TEST_P(LongBodyForceOfEveryModel, BalancesTheDivergenceOfTheFullField) {
  expect_balance(GetParam(), Amplitude::Type::sine, 8);
}

INSTANTIATE_TEST_SUITE_P(Models, LongBodyForceOfEveryModel, testing::ValuesIn(all_model_cases()),
                         [](const auto& instance) { return instance.param.name; });

ModelCase case_of(const std::vector<ModelCase>& cases, const std::string& model) {
  for (const ModelCase& c : cases) {
    if (c.model == model) return c;
  }
  throw std::runtime_error(model);
}

/// The naive path derivative (21) is right for hyperelasticity alone.
TEST(BodyForceNegativeControl, TheNaivePathDerivativeFailsWithMemory) {
  const ModelCase zener = case_of(quick_model_cases(), "zener"), elastic = case_of(quick_model_cases(), "neo_hookean");
  for (const Amplitude::Type type : {Amplitude::Type::sine, Amplitude::Type::one_minus_cosine}) {
    for (const auto& [c, lower, upper] : {std::tuple{zener, 0.5, 1e300}, std::tuple{elastic, 0.0, 1e-6}}) {
      const Setting setting = setting_of(c, type);
      const Sheet sheet = sheet_of(c, setting);
      const ForceDifference d = force_difference(c, setting, sheet, places_in(setting, sheet, 6));
      EXPECT_LT(d.sheet, 1e-8) << c.name;
      EXPECT_GE(d.naive, lower) << c.name;
      EXPECT_LE(d.naive, upper) << c.name;
    }
  }
}

TEST(BodyForceNegativeControl, TheNaivePathDerivativeFailsForUnloadedJ2) {
  ModelCase c = case_of(all_model_cases(), "j2_jaumann");
  Setting setting = setting_of(c, Amplitude::Type::sine);
  setting.end = 1;
  const Sheet sheet(c.material(), setting.vortex.baseline(), {.tolerance = 1e-7, .end = setting.end});
  const ForceDifference d = force_difference(c, setting, sheet, places_in(setting, sheet, 6, 0.52));
  EXPECT_LT(d.sheet, 1e-6);
  EXPECT_GT(d.naive, 0.5);
}

}  // namespace
}  // namespace assay::model_tests::test_body_forces
