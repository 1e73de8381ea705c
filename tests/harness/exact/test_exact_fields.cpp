// SPDX-License-Identifier: BSD-3-Clause
// The three families of exact solutions by one interface, in their own frame and in any other.
#include "harness/exact/exact_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_exact_fields {
namespace {

constexpr double rho = 1000, last = 0.5;
constexpr double of_rounding = 1e-12, of_series = 1e-6;  ///< relative to the largest

std::shared_ptr<const Material> relaxing() {
  return builtin_material(assay_builtin_zener, {{"E", 1e4}, {"nu", 0.3}, {"relaxation_time", 0.1}});
}

struct Solution {
  std::string name;
  ExactSolutionPtr exact;
  double tolerance;
};

ExactSolutionPtr ring(const Motion& motion, const std::shared_ptr<const Material>& material, bool shadow) {
  const Path path = motion->baseline();
  if (shadow) {
    const auto points = std::make_shared<Shadow>(material, path, ShadowOptions{.radii = 40, .end = last});
    return exact_polar(motion, rho, std::make_shared<const Response>(points));
  }
  return exact_polar(motion, rho,
                     std::make_shared<const Response>(Sheet(*material, path, {.tolerance = 1e-9, .end = last})));
}

/// Elastic, or with a history that is taken along.
std::vector<Solution> solutions(bool history) {
  const auto material = history ? relaxing() : elastic_material(1e4, 0.3);
  Vortex vortex;
  vortex.amplitude.peak = 0.3;
  TwistingRing twisting;
  twisting.twist = vortex;
  twisting.expansion = 0.05;
  AxisAligned box;
  box.amplitude = {Amplitude::Type::sine, 0.1, 0.5};
  RotatingStretch stretch;
  stretch.stretch = 0.2, stretch.shear = 0.1, stretch.rotation = 0.7;
  return {{"vortex", ring(vortex, material, history), of_rounding},
          {"twisting_ring", ring(twisting, material, history), of_rounding},
          {"axis_aligned", exact_box(box, rho, material, {.tolerance = 1e-8, .end = last}), of_series},
          {"rotating_stretch", exact_uniform(stretch, rho, material, Motion(stretch)->baseline(), last, 1e-12),
           of_rounding}};
}

const std::vector<double> X{0.8, -0.3, 0.6, 0.1}, Y{0.2, 0.95, -0.7, 0.97};

/// All that an instant says of its points.
std::vector<double> all_of(ExactInstant& now, double t) {
  now.set_time(t);
  std::vector<double> b_x(X.size()), b_y(X.size()), all;
  now.body_force(b_x, b_y);
  const auto add = [&](const auto& values) { all.insert(all.end(), values.begin(), values.end()); };
  for (std::size_t p = 0; p < X.size(); ++p) {
    const PlaneState s = now.state(p);
    const PlaneInertia inertia = now.inertia(p);
    add(s.x), add(s.v), add(s.F), add(s.sigma), add(now.first_piola_kirchhoff(p)), add(inertia.a);
    add(inertia.gradient), add(now.F_rate(p)), add(now.velocity(p));
  }
  add(b_x), add(b_y);
  return all;
}

constexpr Asked everything{true, true, true, true};

/// At points, as the solution says it of each alone.
void expect_alike(const Solution& given, const ExactSolutionPtr& exact, double t) {
  const auto now = exact->instant({X, Y}, everything);
  now->set_time(t);
  std::vector<double> b_x(X.size()), b_y(X.size());
  now->body_force(b_x, b_y);
  for (std::size_t p = 0; p < X.size(); ++p) {
    const auto [state, stress] = exact->at({X[p], Y[p], 0}, t);
    const PlaneState s = now->state(p);
    const Plane P = now->first_piola_kirchhoff(p), rate = now->F_rate(p);
    const double of_stress = given.tolerance * (1 + stress.first_piola_kirchhoff.norm());
    for (int i = 0; i < 2; ++i) {
      const auto d = static_cast<std::size_t>(i);
      EXPECT_NEAR(s.x[d], state.x[i], of_rounding) << given.name;
      EXPECT_NEAR(s.v[d], state.v[i], of_rounding * (1 + state.v.norm())) << given.name;
      EXPECT_NEAR(now->velocity(p)[d], state.v[i], of_rounding * (1 + state.v.norm())) << given.name;
      EXPECT_NEAR(now->inertia(p).a[d], state.a[i], of_rounding * (1 + state.a.norm())) << given.name;
      EXPECT_NEAR(i == 0 ? b_x[p] : b_y[p], stress.body_force[i],
                  100 * given.tolerance * (1 + stress.body_force.norm()))
          << given.name;
      for (int j = 0; j < 2; ++j) {
        const auto c = static_cast<std::size_t>(2 * i + j);
        EXPECT_NEAR(s.F[c], state.F(i, j), of_rounding) << given.name;
        EXPECT_NEAR(rate[c], state.F_rate(i, j), of_rounding * (1 + state.F_rate.norm())) << given.name;
        EXPECT_NEAR(P[c], stress.first_piola_kirchhoff(i, j), of_stress) << given.name;
        EXPECT_NEAR(s.sigma[c], stress.cauchy(i, j), of_stress) << given.name;
      }
    }
    EXPECT_NEAR(s.sigma[4], stress.cauchy(2, 2), of_stress) << given.name;
  }
}

TEST(ExactFields, OfManyPointsAreThoseOfEach) {
  for (const Solution& s : solutions(false)) {
    for (const double t : {0.13, 0.41}) expect_alike(s, s.exact, t);
  }
}

/// x', v', F', sigma', P', b' of single points come from the frame's own formulas.
TEST(ExactFields, AFrameServesAllFamilies) {
  const Frame frame{0.4, 1.3, {0.2, -0.1, 0}};
  for (const Solution& s : solutions(false)) {
    for (const double t : {0.13, 0.41}) expect_alike(s, seen_from(frame, s.exact), t);
  }
}

TEST(ExactFields, ATimeMayBeEarlierThanTheLast) {
  for (const bool history : {false, true}) {
    const auto used = solutions(history), fresh = solutions(history);
    for (std::size_t k = 0; k < used.size(); ++k) {
      const auto now = used[k].exact->instant({X, Y}, everything);
      all_of(*now, 0.4);
      EXPECT_EQ(all_of(*now, 0.2), all_of(*fresh[k].exact->instant({X, Y}, everything), 0.2)) << used[k].name;
    }
  }
}

TEST(ExactFields, ThreadsMayAskOneSolutionForTimesOfTheirOwn) {
  for (const Solution& s : solutions(false)) {
    std::vector<std::vector<double>> found(2);
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < 2; ++k) {
      threads.emplace_back([&, k] {
        const auto now = s.exact->instant({X, Y}, everything);
        for (int step = 1; step <= 20; ++step) found[k] = all_of(*now, (k == 0 ? 0.02 : 0.017) * step);
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(found[0], all_of(*s.exact->instant({X, Y}, everything), 0.02 * 20)) << s.name;
    EXPECT_EQ(found[1], all_of(*s.exact->instant({X, Y}, everything), 0.017 * 20)) << s.name;
  }
}

}  // namespace
}  // namespace assay::test_exact_fields
