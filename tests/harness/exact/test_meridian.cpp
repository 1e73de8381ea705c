// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/meridian.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "harness/exact/exact_fields.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/exact/turning_body.hpp"
#include "tests/harness/fibre_material.hpp"
#include "tests/harness/relaxing_mooney.hpp"

namespace assay::test_meridian {
namespace {

using turning_body::BruteForce;

constexpr double rho = 1000, t_end = 0.8;
constexpr double of_kinematics = 1e-12;  ///< of the largest: complex steps are exact, differences in time to 1e-13
constexpr double of_histories = 2e-12;   ///< of the largest P: two integrations, each to 1e-13 of a step
constexpr double of_force = 1e-9;        ///< of the largest b
constexpr double of_kinks = 1e-6;        ///< of the largest b, with differences so short that no front lies in them
constexpr double step = 6e-3;            ///< of a difference, of the radius: its eighth power is rounding

std::vector<Revolution> shapes(int power, const Vector3& axis, const Vector3& center) {
  Revolution ball{.radius = 1, .profile_power = power, .axis = axis, .center = center};
  Revolution torus = ball, drum = ball;
  torus.profile = Revolution::Profile::torus, torus.ring_radius = 0.6, torus.radius = 0.35;
  drum.profile = Revolution::Profile::drum, drum.height = 0.7, drum.height_power = power == 2 ? 3 : power;
  drum.strength = -0.8;
  return {ball, torus, drum};
}

std::string name_of(const Revolution& r) { return names_of(r.profile)[static_cast<std::size_t>(r.profile)]; }

/// Random places in the body, on its axis, on the circles where Grad h = 0, on its edge.
std::vector<Vector3> places_in(const Revolution& r, int random, unsigned seed) {
  const Vector3 n = r.axis.normalized(), e = n.unitOrthogonal(), f = n.cross(e);
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto place = [&](double R, double Z) {
    const double angle = 2 * std::numbers::pi * share(generator);
    return Vector3(r.center + R * (std::cos(angle) * e + std::sin(angle) * f) + Z * n);
  };
  std::vector<Vector3> places;
  const auto [wide, high] = r.reach();
  while (static_cast<int>(places.size()) < random) {
    const double R = wide * share(generator), Z = high * (2 * share(generator) - 1);
    if (r.at(R, Z)) places.push_back(place(R, Z));
  }
  const double a = r.radius;
  switch (r.profile) {
    case Revolution::Profile::ball:
      for (const double Z : {0.0, 0.4, -0.9}) places.push_back(place(0, Z));
      for (const double angle : {0.0, 0.5, 1.2}) places.push_back(place(a * std::cos(angle), a * std::sin(angle)));
      break;
    case Revolution::Profile::torus:
      for (int k = 0; k < 3; ++k) places.push_back(place(*r.ring_radius, 0));
      places.push_back(place(*r.ring_radius + 1e-6, -2e-6));
      for (const double angle : {0.0, 1.1, 3.0})
        places.push_back(place(*r.ring_radius + a * std::cos(angle), a * std::sin(angle)));
      break;
    case Revolution::Profile::drum:
      for (const double Z : {0.0, 0.3, -0.69}) places.push_back(place(0, Z));
      places.push_back(place(1e-6, 1e-6));
      for (const double Z : {0.0, 0.4}) places.push_back(place(a, Z));
      for (const double R : {0.2, 0.8}) places.push_back(place(R, *r.height));
      break;
  }
  return places;
}

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

/// Largest deviations and largest values over some points.
struct Largest {
  double deviation = 0, value = 0;
  void see(const auto& found, const auto& wanted) {
    deviation = std::max(deviation, (found - wanted).norm());
    value = std::max(value, wanted.norm());
  }
  double relative() const { return deviation / value; }
};

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

TEST(Meridian, BodyForceIsThatOfDifferences) {
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
TEST(Meridian, WhatAPlaneVortexDoesNotHaveIsSeen) {
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

/// A fibre along N, E_Theta or M: each point has its own, and one sheet tells them all.
TEST(Meridian, ADirectionAlongTheAxesOfTheShearIsServed) {
  const Revolution shape = shapes(4, {1, 2, 3}, {0.1, 0, 0})[1];
  const Vortex3d motion{shape, {}, {Amplitude::Type::sine, 0.3, 1}};
  const double t = 0.4;
  for (int along = 0; along < 3; ++along) {
    Path path = motion.baseline();
    path.material_direction = {0, 0, 0};
    path.material_direction[static_cast<std::size_t>(along)] = 1;
    const Sheet sheet(*fibre_material(), path, {.tolerance = 1e-12, .end = 1});
    const auto exact = exact_meridian(motion, rho, std::make_shared<const Response>(sheet));
    const auto P = [&](const Vector3& X) {
      const Tensor F = turning_body::gradient(shape, motion.amplitude.at(t).value, X);
      return Tensor(Fibre::kirchhoff(F, motion.place(X)->axes().col(along)) * F.inverse().transpose());
    };
    const BruteForce brute(shape, motion.amplitude, nullptr, rho, step);
    Largest b, stress;
    for (const Vector3& X : places_in(shape, 20, 6)) {
      const auto p = motion.place(X);
      if (p->G * shape.radius < 0.3 || shape.depth(X) < 0.2) continue;  // N itself is differenced
      Vector3 wanted = brute.a(X, t);
      for (int j = 0; j < 3; ++j) {
        wanted -= turning_body::difference([&](double dx) { return P(X + dx * Vector3::Unit(j)); }, 1e-3).col(j) / rho;
      }
      const ExactStress found = exact->at(X, t).stress;
      b.see(found.body_force, wanted), stress.see(found.first_piola_kirchhoff, P(X));
    }
    EXPECT_GT(b.value, 0.1);
    EXPECT_LT(stress.relative(), of_kinematics) << along;
    EXPECT_LT(b.relative(), of_force) << along;
  }
}

TEST(Meridian, OfPlasticityFartherThanADifferenceFromItsFronts) {
  const Model model{
      "j2_jaumann",
      builtin_material(
          assay_builtin_j2_jaumann,
          {{"E", 1e6}, {"nu", 0.3}, {"yield_stress", 1.5e4}, {"hardening_modulus", 1e5}, {"kinematic_modulus", 1e5}})};
  constexpr double short_step = 2e-5, far_from_front = 1e-4;
  std::set<std::size_t> parts;  // elastic and plastic
  for (const Revolution& shape : shapes(4, {1, 2, 3}, {0.1, 0, 0})) {
    const Vortex3d motion{shape, {}, {Amplitude::Type::sine, 0.1, 1}};
    const BruteForce brute(shape, motion.amplitude, model.material, rho, short_step);
    const auto exact = solution_of(model, motion);
    const auto slice = exact->slice(t_end);
    EXPECT_TRUE(slice->has_parts());
    Largest b;
    std::vector<Vector3> places = places_in(shape, 4, 4);
    places.erase(places.begin() + 5, places.end());
    for (const Vector3& X : places) {
      const auto part = slice->part(X);
      bool near = false;
      for (int k = 0; k < 6; ++k)
        near |= slice->part(X + (k % 2 ? far_from_front : -far_from_front) * Vector3::Unit(k / 2)) != part;
      if (near) continue;
      parts.insert(part);
      b.see(slice->at(X).stress.body_force, brute.body_force(X, t_end));
    }
    EXPECT_LT(b.relative(), of_kinks) << name_of(shape);
  }
  EXPECT_GT(parts.size(), 1U);
}

}  // namespace
}  // namespace assay::test_meridian
