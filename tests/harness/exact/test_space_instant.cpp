// SPDX-License-Identifier: BSD-3-Clause
// The exact fields at fixed points of space, in the body's own frame and in any other.
#include "harness/exact/space_instant.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::test_space_instant {
namespace {

constexpr double rho = 1000, last = 0.7;
constexpr double of_rounding = 1e-12;    ///< relative to the largest
constexpr double of_differences = 1e-9;  ///< of eighth order

std::shared_ptr<const Material> mooney() {
  return builtin_material(assay_builtin_mooney_rivlin, {{"c10", 200}, {"c01", 150}, {"bulk_modulus", 800}});
}

struct Solution {
  std::string name;
  ExactSolutionPtr exact;
};

std::vector<Solution> solutions() {
  const auto material = mooney();
  Vortex3d ball;
  ball.one.axis = {1, 2, 3}, ball.one.center = {0.1, -0.2, 0.05};
  ball.amplitude.peak = 0.8;
  Vortex plane;
  plane.amplitude.peak = 0.3, plane.profile_power = 4;
  AxisAligned box;
  box.amplitude = {Amplitude::Type::sine, 0.1, 0.5};
  box.in_space = true;
  RotatingStretch stretch;
  stretch.stretch = 0.2, stretch.shear = 0.1, stretch.rotation = 0.7, stretch.axis = {1, 2, 3};
  const auto response = [&](const Path& path) {
    return std::make_shared<const Response>(Sheet(*material, path, {.tolerance = 1e-10, .end = last}));
  };
  return {{"vortex3d", exact_meridian(ball, rho, response(ball.baseline()))},
          {"vortex", exact_polar(plane, rho, response(plane.baseline()))},
          {"axis_aligned", exact_box(box, rho, material, {.tolerance = 1e-8, .end = last})},
          {"rotating_stretch", exact_uniform(stretch, rho, material, stretch.baseline(), last, 1e-12)}};
}

const std::vector<double> X{0.4, -0.3, 0.6, 0.9, 2}, Y{0.2, 0.55, -0.4, 0.2, 0.1}, Z{0.3, -0.2, 0.5, 0.1, -0.3};
const SpaceInstant::Points points{X, Y, Z};
constexpr Asked everything{true, true, true, true};
const Frame turned{0.7, 1.3, {0.4, -0.2, 0.3}, {-2, 1, 0.5}};

/// Each solution, and as a frame sees it.
std::vector<Solution> seen_solutions() {
  std::vector<Solution> all = solutions();
  for (const Solution& own : solutions()) all.push_back({own.name + " in a frame", seen_from(turned, own.exact)});
  return all;
}

Vector3 place(std::size_t p) { return {X[p], Y[p], Z[p]}; }

template <std::size_t N>
double distance(const std::array<double, N>& a, const auto& b) {
  double largest = 0;
  for (std::size_t c = 0; c < N; ++c) largest = std::max(largest, std::abs(a[c] - b.data()[c]));
  return largest;
}

TEST(SpaceInstant, SaysOfItsPointsWhatTheSolutionSaysOfEachAlone) {
  for (const auto& [name, exact] : seen_solutions()) {
    SpaceInstant now(exact, points, everything);
    std::vector<double> all(3 * X.size());
    for (const double t : {0.3, last, 0.1}) {
      now.set_time(t);
      const std::size_t n = X.size();
      now.body_force(0, n, {all.data(), all.data() + n, all.data() + 2 * n});
      for (std::size_t begin = 0; begin < n; begin += 2) {
        const auto window = now.window(begin, std::min(n, begin + 2));
        for (std::size_t p = begin; p < std::min(n, begin + 2); ++p) {
          const auto [state, stress] = exact->at(place(p), t);
          const SpaceState found = window.state(p);
          const std::string where = name + ", point " + std::to_string(p) + ", t = " + std::to_string(t);
          const Tensor F = state.F.transpose(), P = stress.first_piola_kirchhoff.transpose();  // row-major data
          const double scale = 1 + stress.first_piola_kirchhoff.norm();
          EXPECT_LT(distance(found.x, state.x), of_rounding) << where;
          EXPECT_LT(distance(found.v, state.v), of_rounding * (1 + state.v.norm())) << where;
          EXPECT_LT(distance(window.velocity(p), state.v), of_rounding * (1 + state.v.norm())) << where;
          EXPECT_LT(distance(window.acceleration(p), state.a), of_rounding * (1 + state.a.norm())) << where;
          EXPECT_LT(distance(found.F, F), of_rounding) << where;
          EXPECT_LT(distance(window.first_piola_kirchhoff(p), P), 1e-9 * scale) << where;
          const std::array<int, 6> voigt{0, 4, 8, 1, 2, 5};
          for (std::size_t c = 0; c < 6; ++c)
            EXPECT_NEAR(found.sigma[c], component(stress.cauchy, voigt[c]), 1e-9 * scale) << where;
          for (std::size_t d = 0; d < 3; ++d)
            EXPECT_NEAR(all[d * n + p], stress.body_force(static_cast<int>(d)), 1e-8 * (1 + stress.body_force.norm()))
                << where;
        }
      }
    }
  }
}

TEST(SpaceInstant, AWindowServesAnotherTimeToo) {
  for (const auto& [name, exact] : seen_solutions()) {
    SpaceInstant now(exact, points, {.stress = true}), later(exact, points, {.motion = true});
    now.set_time(0.2), later.set_time(last);
    const std::size_t n = X.size();
    const auto first = now.window(1, n), same = later.window(first), own = later.window(1, n);
    for (std::size_t p = 1; p < n; ++p) {
      const std::string where = name + ", point " + std::to_string(p);
      EXPECT_EQ(same.state(p).x, own.state(p).x) << where;
      EXPECT_EQ(same.velocity(p), own.velocity(p)) << where;
      if (same.moves(p)) EXPECT_NE(same.state(p).x, first.state(p).x) << where;
      for (const auto& [window, instant] : {std::pair{&first, &now}, {&same, &later}}) {
        EXPECT_EQ(window->moves(p), instant->slice().moves(place(p))) << where;
        EXPECT_LT(distance(window->displacement(p), instant->slice().displacement(place(p))), of_rounding) << where;
      }
    }
  }
}

// By differences of the acceleration itself, whatever the formula.
TEST(SpaceInstant, TheGradientOfTheAccelerationIsThatOfItsDifferences) {
  for (const auto& [name, exact] : seen_solutions()) {
    SpaceInstant now(exact, points, {.inertia = true});
    constexpr double t = 0.3, step = 5e-3;
    now.set_time(t);
    const auto window = now.window(0, X.size());
    for (std::size_t p = 0; p < X.size(); ++p) {
      Tensor differences;
      for (int d = 0; d < 3; ++d) {
        differences.col(d) = central_difference(
            [&, &motion = exact](int k) -> Vector3 {
              return motion->state(place(p) + k * step * Vector3::Unit(d), t).a;
            },
            step);
      }
      const Tensor transposed = differences.transpose();
      EXPECT_LT(distance(window.inertia(p).gradient, transposed), of_differences * (1 + differences.norm()))
          << name << ", point " << p;
    }
  }
}

TEST(SpaceInstant, MeasuresShearOfVorticesAndVolumeOfOthers) {
  constexpr double t = 0.4;
  for (const auto& [name, exact] : seen_solutions()) {
    SpaceInstant now(exact, points, {.motion = true});
    now.set_time(t);
    const auto window = now.window(0, X.size());
    for (std::size_t p = 0; p < X.size(); ++p) {
      const Vector3 own = name.ends_with("frame") ? turned.body_point(place(p)) : place(p);
      double expected = exact->state(place(p), t).F.determinant();
      if (const auto* vortex = exact->motion().as<Vortex3d>()) {
        const auto at = vortex->place(own);
        expected = at ? 2 * at->xi * vortex->amplitude.at(t).value : 0;
        EXPECT_EQ(window.moves(p), at.has_value()) << name;
      } else if (const auto* plane = exact->motion().as<Vortex>()) {
        const double R = std::hypot(own.x(), own.y());
        expected = 2 * ring_parameter(*plane, R).value * plane->amplitude.at(t).value;
        EXPECT_EQ(window.moves(p), R >= plane->inner && R <= plane->outer) << name;
      }
      EXPECT_NEAR(window.measure(p, window.state(p).F), expected, 1e-12) << name << ", point " << p;
      const Vector3 u = exact->motion()->at(own, t).x - own;
      EXPECT_LT(distance(window.displacement(p), u), of_rounding) << name;
    }
  }
}

}  // namespace
}  // namespace assay::test_space_instant
