// SPDX-License-Identifier: BSD-3-Clause
// The vortex in three dimensions of models that have a direction, or kinks.
#include <gtest/gtest.h>

#include <set>

#include "harness/exact/exact_fields.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/exact/turning_body.hpp"
#include "tests/harness/fibre_material.hpp"

namespace assay::test_meridian_models {
namespace {

using namespace assay::turning_body;

constexpr double rho = 1000, t_end = 0.8;
constexpr double of_kinematics = 1e-12;  ///< of the largest P: one update
constexpr double of_force = 1e-9;        ///< of the largest b
constexpr double of_kinks = 1e-6;        ///< of the largest b, with differences so short that no front lies in them
constexpr double step = 6e-3;            ///< of a difference, of the radius: its eighth power is rounding

/// A fibre along N, E_Theta or M: each point has its own, and one sheet tells them all.
TEST(MeridianModels, ADirectionAlongTheAxesOfTheShearIsServed) {
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
      const Tensor F = gradient(shape, motion.amplitude.at(t).value, X);
      return Tensor(Fibre::kirchhoff(F, motion.place(X)->axes().col(along)) * F.inverse().transpose());
    };
    const BruteForce brute(shape, motion.amplitude, nullptr, rho, step);
    Largest b, stress;
    for (const Vector3& X : places_in(shape, 20, 6)) {
      const auto p = motion.place(X);
      if (p->G * shape.radius < 0.3 || shape.depth(X) < 0.2) continue;  // N itself is differenced
      Vector3 wanted = brute.a(X, t);
      for (int j = 0; j < 3; ++j) {
        wanted -= difference([&](double dx) { return P(X + dx * Vector3::Unit(j)); }, 1e-3).col(j) / rho;
      }
      const ExactStress found = exact->at(X, t).stress;
      b.see(found.body_force, wanted), stress.see(found.first_piola_kirchhoff, P(X));
    }
    EXPECT_GT(b.value, 0.1);
    EXPECT_LT(stress.relative(), of_kinematics) << along;
    EXPECT_LT(b.relative(), of_force) << along;
  }
}

TEST(LongMeridianModels, OfPlasticityFartherThanADifferenceFromItsFronts) {
  const auto material = builtin_material(
      assay_builtin_j2_jaumann,
      {{"E", 1e6}, {"nu", 0.3}, {"yield_stress", 1.5e4}, {"hardening_modulus", 1e5}, {"kinematic_modulus", 1e5}});
  constexpr double short_step = 2e-5, far_from_front = 1e-4;
  std::set<std::size_t> parts;  // elastic and plastic
  for (const Revolution& shape : shapes(4, {1, 2, 3}, {0.1, 0, 0})) {
    const Vortex3d motion{shape, {}, {Amplitude::Type::sine, 0.1, 1}};
    const BruteForce brute(shape, motion.amplitude, material, rho, short_step);
    const Sheet sheet(*material, motion.baseline(), {.tolerance = 1e-12, .end = t_end});
    const auto exact = exact_meridian(motion, rho, std::make_shared<const Response>(sheet));
    const auto slice = exact->slice(t_end);
    EXPECT_TRUE(slice->has_parts(ExactSlice::Smooth::stress));
    Largest b;
    std::vector<Vector3> places = places_in(shape, 4, 4);
    places.erase(places.begin() + 5, places.end());
    for (const Vector3& X : places) {
      const auto part = slice->part(X, ExactSlice::Smooth::stress);
      bool near = false;
      for (int k = 0; k < 6; ++k)
        near |= slice->part(X + (k % 2 ? far_from_front : -far_from_front) * Vector3::Unit(k / 2),
                            ExactSlice::Smooth::stress) != part;
      if (near) continue;
      parts.insert(part);
      b.see(slice->at(X).stress.body_force, brute.body_force(X, t_end));
    }
    EXPECT_LT(b.relative(), of_kinks) << name_of(shape);
  }
  EXPECT_GT(parts.size(), 1U);
}

}  // namespace
}  // namespace assay::test_meridian_models
