// SPDX-License-Identifier: BSD-3-Clause
// Registered points: a field is a function of X and t alone, to the last bit, and what each point says of itself.
#include "harness/exact/places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_places {
namespace {

constexpr double rho = 1000, last = 0.5;
constexpr double of_rounding = 1e-12, of_history = 1e-9;  ///< relative to the largest

std::shared_ptr<const Material> material_of(int which) {
  if (which == 0) return elastic_material(1e4, 0.3);
  if (which == 1) return builtin_material(assay_builtin_zener, {{"E", 1e4}, {"nu", 0.3}, {"relaxation_time", 0.1}});
  return builtin_material(assay_builtin_j2_jaumann,
                          {{"E", 1e6}, {"nu", 0.3}, {"yield_stress", 1.5e4}, {"hardening_modulus", 1e5}});
}

struct Case {
  std::string name;
  ExactSolutionPtr exact;
  std::vector<Vector3> X;
};

/// Some of each kind: random ones, several of one radius, an edge, the axis, outside.
std::vector<Vector3> points_of(std::size_t n, bool in_space) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(-1.3, 1.3);
  std::vector<Vector3> X{{0.9, 0.2, 0}, {0.2, 0.9, 0}, {-0.9, 0.2, 0}, {0.75, 0, 0}, {1.25, 0, 0}};
  if (in_space) X.insert(X.end(), {{0, 0, 0}, {0, 0, 0.4}, {0.3, 0, 0}});
  while (X.size() < n) X.emplace_back(place(generator), place(generator), in_space ? place(generator) : 0);
  return X;
}

std::vector<Case> cases(int which, std::size_t n) {
  const auto material = material_of(which);
  const auto response = [&](const Path& path) {
    return std::make_shared<const Response>(Sheet(*material, path, {.tolerance = 1e-7, .end = last}));
  };
  const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.3, 1}};
  const TwistingRing twisting{vortex, 0.05};
  AxisAligned box;
  box.amplitude = {Amplitude::Type::sine, 0.1, 0.5};
  AxisAligned box_in_space = box;
  box_in_space.in_space = true;
  RotatingStretch stretch;
  stretch.stretch = 0.2, stretch.shear = 0.1, stretch.rotation = 0.7;
  const Vortex3d ball{{.axis = {1, 2, 3}}, {}, {Amplitude::Type::sine, 0.2, 1}};
  std::vector<Vector3> in_ring;
  for (std::size_t k = 0; k < n; ++k) {
    const double R = 0.75 + 0.5 * double(k % 7) / 6, Theta = 0.37 * double(k);
    in_ring.emplace_back(R * std::cos(Theta), R * std::sin(Theta), 0);
  }
  const auto plane = points_of(n, false), space = points_of(n, true);
  const auto few = [](std::vector<Vector3> X) { return X.resize(std::min<std::size_t>(X.size(), 6)), X; };
  const BoxOptions in_box{.end = last};
  std::vector<Case> all{
      {"vortex", exact_polar(vortex, rho, response(Motion(vortex)->baseline())), plane},
      {"twisting_ring", exact_polar(twisting, rho, response(Motion(twisting)->baseline())), in_ring},
      {"vortex3d", exact_meridian(ball, rho, response(ball.baseline())), space},
      {"axis_aligned", exact_box(box, rho, material, in_box), which == 0 ? plane : few(plane)},
      {"axis_aligned in space", exact_box(box_in_space, rho, material, in_box), which == 0 ? space : few(space)},
      {"rotating_stretch", exact_uniform(stretch, rho, material, Motion(stretch)->baseline(), last, 1e-12), plane},
  };
  const Frame frame{0.4, 1.3, {0.2, -0.1, 0}};
  all.push_back({"vortex in a frame", seen_from(frame, all[0].exact), plane});
  all.push_back({"vortex3d in a frame", seen_from(Frame{0.4, 1.3, {0.2, 0, 1}, {3, 1, 2}}, all[2].exact), space});
  return all;
}

using Columns = std::vector<PointFields>;

Columns all_fields(const ExactPlaces& places, const ExactSlice& now) {
  Columns fields(places.size());
  places.evaluate(now, 0, places.size(), PointFields::views(fields.data()));
  return fields;
}

/// What all fields hold, as numbers one after another.
std::span<const double> numbers(const Columns& fields) {
  return {reinterpret_cast<const double*>(fields.data()), fields.size() * sizeof(PointFields) / sizeof(double)};
}

void expect_same_bits(std::span<const double> a, std::span<const double> b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) << what;
}

TEST(LongPlaces, AFieldDoesNotDependOnWhatElseIsAsked) {
  for (const int which : {0, 1, 2}) {
    for (const Case& c : cases(which, 700)) {
      const auto places = c.exact->places(c.X);
      const auto now = c.exact->slice(0.31);
      const Columns whole = all_fields(*places, *now);
      Columns again(c.X.size());
      const FieldViews views = PointFields::views(again.data());
      for (auto view : {&FieldViews::x, &FieldViews::v, &FieldViews::a, &FieldViews::F, &FieldViews::P,
                        &FieldViews::sigma, &FieldViews::b, &FieldViews::static_force}) {
        FieldViews one;
        one.*view = views.*view;
        places->evaluate(*now, 0, c.X.size(), one);
      }
      expect_same_bits(numbers(again), numbers(whole), c.name);
      for (std::size_t first = 0; first < c.X.size(); first += 97) {  // parts, which end anywhere
        const std::size_t count = std::min<std::size_t>(97, c.X.size() - first);
        places->evaluate(*now, first, count, views.from(first));
      }
      expect_same_bits(numbers(again), numbers(whole), c.name + " in parts");
      const auto slice = c.exact->slice(0.31);
      for (std::size_t p = 0; p < c.X.size(); p += 13) {
        Columns alone(1);
        PointFields::views(alone.data()).put(0, slice->at(c.X[p]));
        expect_same_bits(numbers(alone), numbers({whole[p]}), c.name + " alone");
      }
    }
  }
}

TEST(LongPlaces, AFieldDoesNotDependOnTheTimesThatWereAskedBefore) {
  for (const int which : {0, 1, 2}) {
    for (const Case& c : cases(which, 20)) {
      const auto places = c.exact->places(c.X);
      std::vector<double> times{0.37, 0.02, 0.5, 0, 0.37, 0.25};
      std::vector<Columns> found;
      for (const double t : times) found.push_back(all_fields(*places, *c.exact->slice(t)));
      expect_same_bits(numbers(found[0]), numbers(found[4]), c.name);
      for (std::size_t k = times.size(); k-- > 0;) {
        const auto other = c.exact->places(c.X);
        expect_same_bits(numbers(all_fields(*other, *c.exact->slice(times[k]))), numbers(found[k]), c.name);
      }
    }
  }
}

TEST(Places, ThreadsGetTheSameBits) {
  for (const int which : {0, 1}) {
    for (const Case& c : cases(which, 300)) {
      const auto places = c.exact->places(c.X);
      const std::vector<double> times{0.1, 0.2, 0.3, 0.4};
      std::vector<Columns> alone, together(times.size());
      for (const double t : times) alone.push_back(all_fields(*places, *c.exact->slice(t)));
      std::vector<std::thread> threads;
      for (std::size_t k = 0; k < times.size(); ++k)
        threads.emplace_back([&, k] { together[k] = all_fields(*places, *c.exact->slice(times[k])); });
      for (std::thread& thread : threads) thread.join();
      for (std::size_t k = 0; k < times.size(); ++k) expect_same_bits(numbers(together[k]), numbers(alone[k]), c.name);
    }
  }
}

/// The motion's own formulas, and the solution seen by the instants that runs have.
TEST(Places, AgreeWithTheMotionAndWithInstants) {
  for (const int which : {0, 1}) {
    for (const Case& c : cases(which, 60)) {
      if (c.name == "vortex3d in a frame" || c.name == "vortex in a frame") continue;
      const double t = 0.31;
      const Columns found = all_fields(*c.exact->places(c.X), *c.exact->slice(t));
      double of_a = 0;
      for (const Vector3& X : c.X) of_a = std::max(of_a, c.exact->state(X, t).a.norm());
      for (std::size_t p = 0; p < c.X.size(); ++p) {
        const ExactPoint point = found[p].point();
        const ExactState state = c.exact->state(c.X[p], t);
        EXPECT_LT((point.state.x - state.x).norm(), of_rounding) << c.name;
        EXPECT_LT((point.state.v - state.v).norm(), of_rounding * (1 + state.v.norm())) << c.name;
        EXPECT_LT((point.state.a - state.a).norm(), of_rounding * of_a) << c.name;
        EXPECT_LT((point.state.F - state.F).norm(), of_rounding) << c.name;
        const Tensor& P = point.stress.first_piola_kirchhoff;
        EXPECT_LT((cauchy_stress(P, state.F) - point.stress.cauchy).norm(), of_rounding * P.norm() + 1e-300) << c.name;
        const Vector3 inertia = point.stress.body_force - point.stress.static_force;
        EXPECT_LT((inertia - state.a).norm(), of_rounding * (of_a + point.stress.body_force.norm())) << c.name;
      }
      if (c.name != "vortex" && c.name != "twisting_ring") continue;
      std::vector<double> X, Y, b_x(c.X.size()), b_y(c.X.size());
      for (const Vector3& at : c.X) X.push_back(at.x()), Y.push_back(at.y());
      const auto now = c.exact->instant({X, Y}, {.motion = true, .stress = true, .force = true});
      now->set_time(t);
      now->body_force(b_x, b_y);
      double of_b = 0;
      for (std::size_t p = 0; p < c.X.size(); ++p) of_b = std::max(of_b, std::hypot(b_x[p], b_y[p]));
      for (std::size_t p = 0; p < c.X.size(); ++p) {
        EXPECT_NEAR(found[p].b[0], b_x[p], of_history * of_b) << c.name;
        EXPECT_NEAR(found[p].b[1], b_y[p], of_history * of_b) << c.name;
        const Plane P = now->first_piola_kirchhoff(p);
        EXPECT_NEAR(found[p].P[1], P[1], of_history * 1e4) << c.name;
        EXPECT_NEAR(found[p].P[3], P[2], of_history * 1e4) << c.name;
      }
    }
  }
}

TEST(Places, AreWrittenWithStrides) {
  const Case c = cases(0, 33).front();
  const auto places = c.exact->places(c.X);
  const auto now = c.exact->slice(0.2);
  const Columns whole = all_fields(*places, *now);
  const std::size_t n = c.X.size();
  std::vector<double> b(2 * n, -1), F(9 * n);
  FieldViews wanted{.dimension = 2};
  wanted.b = {b.data(), 1, static_cast<std::ptrdiff_t>(n)};  // component-major
  wanted.F = {F.data() + 9 * (n - 1), -9, 1};                // the last point first
  places->evaluate(*now, 0, n, wanted);
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_EQ(b[p], whole[p].b[0]);
    EXPECT_EQ(b[n + p], whole[p].b[1]);
    for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(F[9 * (n - 1 - p) + i], whole[p].F[i]);
  }
}

}  // namespace
}  // namespace assay::test_places
