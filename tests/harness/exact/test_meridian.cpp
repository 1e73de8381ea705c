// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/meridian.hpp"

#include <gtest/gtest.h>

#include "harness/exact/exact_fields.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/exact/turning_body.hpp"
#include "tests/harness/relaxing_mooney.hpp"

namespace assay::test_meridian {
namespace {

using namespace assay::turning_body;

constexpr double rho = 1000, t_end = 0.8;
constexpr double of_kinematics = 1e-12;  ///< of the largest: complex steps are exact, differences in time to 1e-13
constexpr double of_histories = 2e-12;   ///< of the largest P: two integrations, each to 1e-13 of a step
constexpr double of_force = 1e-9;        ///< of the largest b
constexpr double step = 6e-3;            ///< of a difference, of the radius: its eighth power is rounding

struct Model {
  std::string name;
  std::shared_ptr<const Material> material;
  bool closed_form = false;
};

std::vector<Model> smooth_models() {
  return {{"neo_hookean", elastic_material(1e3, 0.3), true},
          {"mooney_rivlin",
           builtin_material(assay_builtin_mooney_rivlin, {{"c10", 120}, {"c01", 60}, {"bulk_modulus", 900}}), true},
          {"relaxing_mooney", relaxing_mooney()}};
}

std::shared_ptr<const Response> response_of(const Model& model, const Path& path) {
  if (model.closed_form) return std::make_shared<const Response>(*ClosedForm::of(model.material, path));
  return std::make_shared<const Response>(Sheet(*model.material, path, {.tolerance = 1e-12, .end = t_end}));
}

ExactSolutionPtr solution_of(const Model& model, const Vortex3d& motion) {
  return exact_meridian(motion, rho, response_of(model, motion.baseline()));
}

constexpr double amplitude_of(const Revolution& r) { return r.profile == Revolution::Profile::torus ? 0.3 : 1; }

const std::vector<Amplitude> amplitudes{{Amplitude::Type::sine, 1, 1}, {Amplitude::Type::one_minus_cosine, 1.3, 0.9}};

struct Case {
  Vortex3d motion;
  std::string name;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int power : {2, 3, 4}) {
    for (const bool tilted : {false, true}) {
      const Vector3 axis = tilted ? Vector3(1, 2, 3) : Vector3(0, 0, 1);
      const Vector3 center = tilted ? Vector3(0.2, -0.3, 0.1) : Vector3(0, 0, 0);
      for (const Revolution& shape : shapes(power, axis, center)) {
        Amplitude amplitude = amplitudes[tilted ? 1 : 0];
        amplitude.peak *= amplitude_of(shape);
        all.push_back(
            {{shape, {}, amplitude}, name_of(shape) + ", m = " + std::to_string(power) + (tilted ? ", tilted" : "")});
      }
    }
  }
  return all;
}

TEST(Meridian, MotionIsThatOfComplexSteps) {
  for (const auto& [motion, name] : cases()) {
    const BruteForce brute(motion.one, motion.amplitude, nullptr, rho, step);
    Largest x, v, a, F, F_rate;
    for (const Vector3& X : places_in(motion.one, 60, 1)) {
      for (const double t : {0.21, 0.5, 0.77}) {
        const ExactState now = motion.at(X, t);
        x.see(now.x, brute.x(X, t)), v.see(now.v, brute.v(X, t)), a.see(now.a, brute.a(X, t));
        F.see(now.F, brute.F(X, t));
        F_rate.see(now.F_rate, brute.F_rate(X, t));
        EXPECT_NEAR(now.F.determinant(), 1, of_kinematics) << name;
      }
    }
    EXPECT_LT(x.relative(), of_kinematics) << name;
    EXPECT_LT(v.relative(), of_kinematics) << name;
    EXPECT_LT(a.relative(), of_kinematics) << name;
    EXPECT_LT(F.relative(), of_kinematics) << name;
    EXPECT_LT(F_rate.relative(), of_kinematics) << name;
  }
}

/// The largest deviations of P and b over a body.
struct Deviations {
  Largest P, b;
};

Deviations deviations(const ExactSolution& exact, const BruteForce& brute, const std::vector<Vector3>& places,
                      double t) {
  Deviations found;
  for (const Vector3& X : places) {
    const ExactPoint point = exact.at(X, t);
    found.P.see(point.stress.first_piola_kirchhoff, brute.P(X, t));
    found.b.see(point.stress.body_force, brute.body_force(X, t));
  }
  return found;
}

TEST(LongMeridian, BodyForceIsThatOfDifferences) {
  for (const Model& model : smooth_models()) {
    for (const auto& [motion, name] : cases()) {
      const BruteForce brute(motion.one, motion.amplitude, model.material, rho, step * motion.one.radius);
      const bool history = !model.closed_form;
      if (history && (motion.one.profile_power == 3 || motion.one.center == Vector3::Zero())) continue;  // 216 each
      const auto exact = solution_of(model, motion);
      std::vector<Vector3> places = places_in(motion.one, history ? 3 : 40, 2);
      if (history) places.erase(places.begin() + 5, places.end());
      const auto found = deviations(*exact, brute, places, history ? t_end : 0.62);
      EXPECT_LT(found.P.relative(), history ? of_histories : of_kinematics) << model.name << ", " << name;
      EXPECT_LT(found.b.relative(), of_force) << model.name << ", " << name;
    }
  }
}

/// tau33 and b along the axis are there with these models, so that leaving them out is seen: the controls.
TEST(LongMeridian, WhatAPlaneVortexDoesNotHaveIsSeen) {
  for (const Model& model : smooth_models()) {
    if (model.name == "neo_hookean") continue;
    const Revolution shape = shapes(4, {1, 2, 3}, {0, 0, 0})[0];
    const Vortex3d motion{shape, {}, amplitudes[0]};
    const auto response = response_of(model, motion.baseline());
    const BruteForce brute(shape, motion.amplitude, model.material, rho, step);
    const double t = 0.62;
    const AmplitudeValue g = motion.amplitude.at(t);
    // of a history: what the material would say if it had gone straight to where it is
    Path straight = motion.baseline();
    straight.amplitude = [=](double at) { return g.value * at / t; };
    straight.amplitude_rate = [=](double) { return g.value / t; };
    straight.reversals = [](double) { return std::vector<double>(); };
    Largest right, without_bz, without_slope33, by_path;
    for (const Vector3& X : places_in(shape, 12, 3)) {
      const auto p = motion.place(X);
      const Vector3 wanted = brute.body_force(X, t);
      const MeridianResponse tau = meridian_response(*response->at_time(t), p->xi, HUGE_VAL);
      const Tensor QB = p->rotation(g.value * p->profile.h) * p->axes();
      const auto b = [&](const MeridianResponse& given) {
        return Vector3(state_of(*p, g).a - QB * divergence_piola(*p, g.value, given) / rho);
      };
      right.see(b(tau), wanted);
      without_bz.see(Vector3(b(tau) - b(tau).dot(p->E_Z) * p->E_Z), wanted);
      MeridianResponse spoilt = tau;
      spoilt.dtau_dxi(2, 2) = 0;
      without_slope33.see(b(spoilt), wanted);
      if (model.closed_form) continue;
      // the slope along the path, tau. / xi.: right for a function of F, wrong after the shear has turned back
      Tensor before, after, none;
      constexpr double dt = 1e-4;
      response->at(p->xi, t - dt, before, none), response->at(p->xi, t + dt, after, none);
      spoilt = tau;
      spoilt.dtau_dxi = (after - before) / (2 * dt) * g.value / (p->xi * g.rate);
      if (p->xi > 1e-3) by_path.see(b(spoilt), wanted);
    }
    EXPECT_LT(right.relative(), of_force) << model.name;
    EXPECT_GT(without_bz.relative(), 1e6 * of_force) << model.name;
    EXPECT_GT(without_slope33.relative(), 1e6 * of_force) << model.name;
    if (!model.closed_form) {
      EXPECT_GT(by_path.relative(), 1e6 * of_force);
    }
  }
}

/// Along N, E_Theta, M, by the Cauchy stress: away from the axis and from places where Grad h = 0 [N/m^3].
Vector3 divergence_cauchy(const MeridianPoint& p, double g, const Tensor& tau, const Tensor& slope) {
  const double c = p.c, s = p.s, R = p.R;
  const double h_RR = p.profile.h_RR, h_RZ = p.profile.h_RZ, h_ZZ = p.profile.h_ZZ;
  const double H_NN = c * c * h_RR + 2 * c * s * h_RZ + s * s * h_ZZ;
  const double H_MM = s * s * h_RR - 2 * c * s * h_RZ + c * c * h_ZZ;
  const double H_NM = c * s * (h_ZZ - h_RR) + (c * c - s * s) * h_RZ;
  const double xi_N = 0.5 * (p.G * c + R * H_NN), xi_M = 0.5 * (-p.G * s + R * H_NM);
  const double phi_N = H_NM / p.G, phi_M = H_MM / p.G;
  const double s11 = tau(0, 0), s12 = tau(1, 0), s33 = tau(2, 2), s22 = tau(1, 1) + 2 * p.xi * g * tau(1, 0);
  return {slope(0, 0) * xi_N + (s11 - s33) * phi_M + (s11 - s22) * c / R,
          slope(1, 0) * xi_N + s12 * (phi_M + 2 * c / R),
          slope(2, 2) * xi_M + (s11 - s33) * phi_N + (s22 - s33) * s / R};
}

TEST(Meridian, PiolaAndCauchyFormsOfTheDivergenceAgree) {
  for (const Model& model : smooth_models()) {
    for (const auto& [motion, name] : cases()) {
      const auto response = response_of(model, motion.baseline())->at_time(0.62);
      const double g = motion.amplitude.at(0.62).value;
      Largest divergence;
      for (const Vector3& X : places_in(motion.one, 60, 8)) {
        const auto p = motion.place(X);
        if (p->R < 1e-3 || p->G < 1e-3) continue;
        Tensor tau, slope;
        response->at(p->xi, tau, slope);
        divergence.see(divergence_piola(*p, g, meridian_response(*response, p->xi, HUGE_VAL)),
                       divergence_cauchy(*p, g, tau, slope));
      }
      EXPECT_LT(divergence.relative(), of_force) << model.name << ", " << name;
    }
  }
}

/// (34) in three dimensions: b_r = -R (g' h)^2 + mu g^2 R G^2/rho0, b_z = 0,
/// b_theta = R g'' h - mu g [R (h_RR + h_ZZ) + 3 h_R]/rho0.
TEST(Meridian, OfNeoHookeIsItsClosedForm) {
  const Model model = smooth_models()[0];
  const double mu = 1e3 / (2 * 1.3), t = 0.62;
  for (const auto& [motion, name] : cases()) {
    const auto exact = solution_of(model, motion);
    const AmplitudeValue g = motion.amplitude.at(t);
    Largest b;
    for (const Vector3& X : places_in(motion.one, 60, 9)) {
      const auto p = motion.place(X);
      const MeridianProfile& h = p->profile;
      const double r = -p->R * std::pow(g.rate * h.h, 2) + mu * g.value * g.value * p->R * p->G * p->G / rho;
      const double theta =
          p->R * g.acceleration * h.h - mu * g.value * (p->R * (h.h_RR + h.h_ZZ) + 3 * p->R * h.h_R_by_R) / rho;
      const Vector3 e_r = p->R > 0 ? Vector3(p->rotation(g.value * h.h) * p->radial / p->R) : Vector3::Zero();
      b.see(exact->at(X, t).stress.body_force, Vector3(r * e_r + theta * p->E_Z.cross(e_r)));
    }
    EXPECT_LT(b.relative(), of_kinematics) << name;
  }
}

}  // namespace
}  // namespace assay::test_meridian
