// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/stability_screen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/history/point_driver.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/stability/tangent_modulus.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_stability_screen {
namespace {

using Verdict = StabilityScreen::Verdict;
constexpr double mu = 1e3 / 2.6, lambda = 1e3 * 0.3 / (1.3 * 0.4);

Path vortex_path(double peak, Amplitude::Type type = Amplitude::Type::sine) {
  return Vortex{0.75, 1.25, 2, {type, peak, 1.0}}.baseline();
}

/// Largest |gamma| of the paper's vortex at amplitude 1.
double peak_shear() {
  const Interval xi = Vortex{}.xi_range();
  return 2 * std::max(-xi.lower, xi.upper);
}

std::shared_ptr<const Material> j2(double yield = 5, double hardening = 20) {
  return builtin_material(assay_builtin_j2_jaumann,
                          {{"E", 1e3}, {"nu", 0.3}, {"yield_stress", yield}, {"hardening_modulus", hardening}});
}

TEST(StabilityScreen, ElasticAndViscoelasticSolidsStandThePapersVortex) {
  EXPECT_NEAR(peak_shear(), 7.07, 0.005);
  const StabilityScreen elastic = screen_stability(*elastic_material(), vortex_path(1), 1);
  EXPECT_EQ(elastic.verdict, Verdict::stable);
  EXPECT_NEAR(elastic.smallest, mu / (lambda + 2 * mu), 1e-6);  // isochoric: it stays mu
  EXPECT_EQ(elastic.safe_fraction, 1);
  const auto zener = builtin_material(assay_builtin_zener, {{"E", 1e3}, {"nu", 0.3}, {"relaxation_time", 0.1}});
  EXPECT_EQ(screen_stability(*zener, vortex_path(1), 1).verdict, Verdict::stable);
}

/// Form m.a.n of the Jaumann rate for m, n unit: (lambda + mu)(m.n)^2 + mu + (n.sigma n - m.sigma m)/2, with principal
/// stresses +-2 mu sin(gamma/2): lost at gamma = pi/3.
TEST(StabilityScreen, HypoelasticityLosesItAtOneThirdOfPi) {
  for (const auto& material :
       {builtin_material(assay_builtin_hypoelastic_jaumann, {{"E", 1e3}, {"nu", 0.3}}), jaumann_material()}) {
    const StabilityScreen screen = screen_stability(*material, vortex_path(1), 1);
    ASSERT_EQ(screen.verdict, Verdict::unstable);
    const double gamma = 2 * screen.xi * std::sin(std::numbers::pi * screen.t);
    EXPECT_NEAR(std::abs(gamma), std::numbers::pi / 3, 2e-2) << material->name();
    EXPECT_LT(screen.t, 0.5);  // the first of two times
    EXPECT_NEAR(screen.safe_fraction, std::numbers::pi / 3 / peak_shear(), 2e-4) << material->name();
    EXPECT_LT(screen.smallest, 0);
  }
}

/// The largest safe amplitude is safe, a little more is not; also where the motion begins at rest.
TEST(StabilityScreen, TheSafeAmplitudeIsSafeAndTheNextIsNot) {
  const auto material = builtin_material(assay_builtin_hypoelastic_jaumann, {{"E", 1e3}, {"nu", 0.3}});
  for (const auto type : {Amplitude::Type::sine, Amplitude::Type::one_minus_cosine, Amplitude::Type::ramp}) {
    const double safe = screen_stability(*material, vortex_path(1, type), 1).safe_fraction;
    EXPECT_GT(safe, 0.1);
    EXPECT_EQ(screen_stability(*material, vortex_path(safe, type), 1).verdict, Verdict::stable);
    EXPECT_EQ(screen_stability(*material, vortex_path(1.002 * safe, type), 1).verdict, Verdict::unstable);
  }
}

/// Smallest m.a.n over all m and n in the plane and a few out of it, of the plastic Jaumann solid.
double smallest_form(const Tensor& sigma, double hardening, bool plastic) {
  const Tensor s = sigma - sigma.trace() / 3 * Tensor::Identity(), flow = s / s.norm();
  const double share = plastic ? 2 * mu / (1 + hardening / (3 * mu)) : 0;
  double smallest = std::numeric_limits<double>::infinity();
  constexpr int n = 720;
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const double p = std::numbers::pi * a / n, q = std::numbers::pi * b / n;
      const Vector3 m(std::cos(p), std::sin(p), 0), N(std::cos(q), std::sin(q), 0);
      const double value = (lambda + mu) * std::pow(m.dot(N), 2) + mu + 0.5 * (N.dot(sigma * N) - m.dot(sigma * m)) -
                           share * std::pow(m.dot(flow * N), 2);
      smallest = std::min(smallest, value);
    }
  }
  return smallest;
}

/// While the strain is small the normals of reference and current configuration coincide to first order.
TEST(StabilityScreen, FollowsTheLoadingBranchOfPlasticity) {
  const double yield = 5, hardening = 20, peak = 0.01;
  const Path path = vortex_path(peak);
  const auto material = j2(yield, hardening);
  const StabilityScreen screen = screen_stability(*material, path, 1);
  EXPECT_EQ(screen.verdict, Verdict::stable);
  const double xi = path.parameter.lower, middle = 0.5;
  const Histories h = integrate_histories(*material, path, std::span(&xi, 1), std::span(&middle, 1));
  Tensor sigma;
  for (int c = 0; c < 9; ++c) component(sigma, c) = h.points[0].cauchy[static_cast<std::size_t>(c)];
  ASSERT_GT(sigma.norm(), yield * 0.8);  // it yields
  const double expected = smallest_form(sigma, hardening, true) / (lambda + 2 * mu);
  const double gamma = 2 * std::abs(xi) * peak;
  EXPECT_NEAR(screen.smallest, expected, gamma * expected + 2e-4 * mu / (lambda + 2 * mu));
  // the elastic branch, or the mean of both, would be far away
  EXPECT_GT(smallest_form(sigma, hardening, false) / (lambda + 2 * mu), 10 * screen.smallest);
}

TEST(StabilityScreen, PlasticityStandsSmallRotationsOnly) {
  const double yield = 50, hardening = 100;
  const auto material = j2(yield, hardening);
  EXPECT_EQ(screen_stability(*material, vortex_path(0.1), 1).verdict, Verdict::stable);
  EXPECT_EQ(screen_stability(*material, vortex_path(1), 1).verdict, Verdict::unstable);
  const Path path = vortex_path(1, Amplitude::Type::ramp);
  const StabilityScreen screen = screen_stability(*material, path, 1);
  ASSERT_EQ(screen.verdict, Verdict::unstable);
  EXPECT_GT(screen.safe_fraction, 0.1);
  EXPECT_LT(screen.safe_fraction, 0.99);
  // where it is lost, the closed form vanishes; a tenth of the shear before and after it does not
  double form[3];
  for (int k = 0; k < 3; ++k) {
    const double xi = path.parameter.lower * screen.safe_fraction * (0.9 + 0.1 * k);
    std::vector<double> times;
    for (int i = 1; i <= 64; ++i) times.push_back(i / 64.0);
    const Histories h = integrate_histories(*material, path, std::span(&xi, 1), times);
    Tensor sigma;
    for (int c = 0; c < 9; ++c) component(sigma, c) = h.points.back().cauchy[static_cast<std::size_t>(c)];
    form[k] = smallest_form(sigma, hardening, true) / mu;
  }
  EXPECT_GT(form[0], 5e-3);
  EXPECT_NEAR(form[1], 0, 1e-3);
  EXPECT_LT(form[2], -5e-3);
  const StabilityScreen perfect = screen_stability(*j2(50, 0), vortex_path(0.1), 1);
  EXPECT_EQ(perfect.verdict, Verdict::unstable);  // at first yield, gamma_y = yield / (sqrt 3 mu)
  EXPECT_NEAR(std::abs(2 * perfect.xi * 0.1 * std::sin(std::numbers::pi * perfect.t)), 50 / (std::sqrt(3) * mu), 2e-3);
}

/// sigma = K (J - 1) I + 2 eta dev d, with d of the step.
struct SimpleModel {
  double bulk, viscosity;
};

const assay_material* fluid_table() {
  static const assay_parameter parameters[] = {{"bulk", "Pa", 1e5, 0, 1e12, "K"},
                                               {"viscosity", "Pa s", 0, 0, 1e12, "eta"}};
  static const assay_material table = [] {
    assay_material t = *jaumann_table();
    t.name = "fluid_for_tests";
    t.flags = ASSAY_THREAD_SAFE | ASSAY_USES_INCREMENT | ASSAY_RATE_DEPENDENT;
    t.parameter_count = 2;
    t.parameters = parameters;
    t.state_count = 0;
    t.create = [](const double* p, char*) -> void* { return new SimpleModel{p[0], p[1]}; };
    t.destroy = [](void* self) { delete static_cast<SimpleModel*>(self); };
    t.update = [](void* self, const assay_step* step, std::size_t n, const double*, double*, double* cauchy,
                  std::int32_t* status, double*, char*) {
      const auto& m = *static_cast<const SimpleModel*>(self);
      for (std::size_t p = 0; p < n; ++p) {
        const Tensor F0 = jaumann_detail::tensor_at(step->F0, n, p), F1 = jaumann_detail::tensor_at(step->F1, n, p);
        const Tensor l = (F1 - F0) * (0.5 * (F0 + F1)).inverse() / step->dt, d = 0.5 * (l + l.transpose());
        const Tensor I = Tensor::Identity(), spin_free = d - d.trace() / 3 * I;
        jaumann_detail::put(m.bulk * (F1.determinant() - 1) * I + 2 * m.viscosity * spin_free, cauchy, n, p);
        status[p] = ASSAY_GOOD;
      }
    };
    return t;
  }();
  return &table;
}

TEST(StabilityScreen, FluidsAreNeutral) {
  for (const double viscosity : {0.0, 1.0, 1e3}) {
    const Material fluid(fluid_table(), {{"viscosity", viscosity}});
    const StabilityScreen screen = screen_stability(fluid, vortex_path(1), 1);
    EXPECT_EQ(screen.verdict, Verdict::neutral) << viscosity;
    EXPECT_LT(std::abs(screen.smallest), 1e-3) << viscosity;
  }
  // a solid that is nearly incompressible is none
  EXPECT_EQ(screen_stability(*elastic_material(1e3, 0.49999), vortex_path(1), 1).verdict, Verdict::stable);
}

/// A model that computes in single precision is screened with larger steps.
TEST(StabilityScreen, ServesModelsInSinglePrecision) {
  static const assay_material table = [] {
    assay_material t = *jaumann_table();
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      std::vector<double> F0(step->F0, step->F0 + 9 * n), F1(step->F1, step->F1 + 9 * n);
      for (auto* F : {&F0, &F1}) {
        for (double& v : *F) v = static_cast<float>(v);
      }
      const assay_step rounded{step->t, step->dt, F0.data(), F1.data()};
      jaumann_detail::update(self, &rounded, n, state0, state1, cauchy, status, dt_factor, message);
    };
    return t;
  }();
  const StabilityScreen screen = screen_stability(Material(&table, {}), vortex_path(1), 1);
  ASSERT_EQ(screen.verdict, Verdict::unstable);
  EXPECT_NEAR(screen.safe_fraction, std::numbers::pi / 3 / peak_shear(), 0.01);
}

/// Other paths than simple shear; xi of one sign only.
TEST(StabilityScreen, HomogeneousMotionsHaveASafeShareOfTheWay) {
  Homogeneous stretch;
  stretch.final(0, 0) = 20;
  const StabilityScreen screen = screen_stability(*elastic_material(), stretch.baseline(), 1);
  ASSERT_EQ(screen.verdict, Verdict::unstable);
  // across the stretch: mu + lambda + mu - lambda ln J = 0
  const double J = std::exp((lambda + 2 * mu) / lambda);
  EXPECT_NEAR(screen.safe_fraction, (J - 1) / 19, 2e-4);
  EXPECT_NEAR(screen.t, (J - 1) / 19, 2e-4);
  EXPECT_NEAR(std::abs(screen.normal.x()), 0, 1e-3);
}

TEST(StabilityScreen, PassesAFailureOn) {
  EXPECT_THROW(screen_stability(*jaumann_material(1.0), vortex_path(1), 1), MaterialFailure);
}

/// A material that stands the path and not the screen's own steps beyond it is judged where it can be.
TEST(StabilityScreen, CountsPlacesJustBeyondWhichTheMaterialFails) {
  const double limit = 0.05 * peak_shear() + 5e-5;
  const StabilityScreen screen = screen_stability(*jaumann_material(limit), vortex_path(0.05), 1);
  EXPECT_EQ(screen.verdict, Verdict::stable);
  EXPECT_EQ(screen.unjudged, 1);
  EXPECT_EQ(screen_stability(*jaumann_material(), vortex_path(0.05), 1).unjudged, 0);
}

/// One that stands the path and nothing beside it: then the screen says why it cannot judge.
TEST(StabilityScreen, PassesOnTheFailureOfAMaterialThatNowhereStandsItsSteps) {
  static const assay_material table = [] {
    assay_material t = *assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0);
    t.extension = nullptr;
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      assay_builtin_neo_hookean(ASSAY_ABI_MAJOR, 0)
          ->update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      for (std::size_t p = 0; p < n; ++p) {
        if (std::abs(step->F1[p] - 1) > 1e-12) status[p] = ASSAY_FAILED;  // F11, 1 along the path
      }
    };
    return t;
  }();
  EXPECT_THROW(screen_stability(Material(&table, {{"E", 1e3}, {"nu", 0.3}}), vortex_path(0.05), 1), MaterialFailure);
}

/// A shear that comes and goes, in so many rows.
Path tabulated(int rows, double largest) {
  std::vector<double> times;
  std::vector<Tensor> F;
  for (int k = 0; k <= rows; ++k) {
    times.push_back(static_cast<double>(k) / rows);
    F.push_back(Tensor::Identity());
    F.back()(0, 1) = largest * std::sin(std::numbers::pi * times.back());
  }
  return DeformationTable("rows", times, F, Interpolation::linear).baseline();
}

TEST(StabilityScreen, LooksAtEachRowOfALongTableOnceAndTellsHowFarItIs) {
  constexpr int rows = 3000;
  std::vector<double> shares;
  const Path path = tabulated(rows, 1);
  const StabilityScreen found =
      screen_stability(*elastic_material(), path, 1, [&](double share) { shares.push_back(share); });
  EXPECT_EQ(found.verdict, Verdict::stable);
  EXPECT_EQ(shares.size(), static_cast<std::size_t>(rows));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0);
  EXPECT_LE(shares.back(), 1);
  const StabilityScreen few = screen_stability(*elastic_material(), tabulated(50, 1), 1);
  EXPECT_NEAR(found.smallest, few.smallest, 1e-3 * few.smallest);
}

/// Half of a half turn, F = I + 1/2 (Q - I), is no body at all; a body that turns does not go there.
TEST(StabilityScreen, OfATableOnlyWhatTheBodyGoesThroughCounts) {
  std::vector<double> times;
  std::vector<Tensor> F;
  for (int k = 0; k <= 16; ++k) {
    times.push_back(k / 16.0);
    F.push_back(rotation_about_z(std::numbers::pi * times.back()));
  }
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::spline}) {
    const Path path = DeformationTable("rows", times, F, interpolation).baseline();
    EXPECT_EQ(screen_stability(*elastic_material(), path, 1).verdict, Verdict::stable);
  }
}

void expect_the_loss_of_few_rows(int rows, int few_rows) {
  const StabilityScreen many = screen_stability(*j2(50, 100), tabulated(rows, 7), 1);
  const StabilityScreen few = screen_stability(*j2(50, 100), tabulated(few_rows, 7), 1);
  ASSERT_EQ(few.verdict, Verdict::unstable);
  ASSERT_EQ(many.verdict, Verdict::unstable);
  EXPECT_NEAR(many.t, few.t, 1e-2);
}

// One look at each of 520 rows and more, several at each of few.
TEST(StabilityScreen, ALossBetweenManyRowsIsFoundWhereFewShowIt) { expect_the_loss_of_few_rows(520, 20); }
TEST(LongStabilityScreen, ALossBetweenManyRowsIsFoundWhereFewShowIt) { expect_the_loss_of_few_rows(1100, 100); }

}  // namespace
}  // namespace assay::test_stability_screen
