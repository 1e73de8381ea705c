// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/frame_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/exact/body_force.hpp"
#include "harness/motion/frame.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_frame_force {
namespace {

constexpr double spin = 1.3;
const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.9, 1.1}};

/// Coriolis and centrifugal terms of the own motion, turned by w t.
Vector3 added(const Vector3& X, double t) {
  const Frame frame{0, spin};
  return frame.rotation(t) * frame.coriolis_and_centrifugal(vortex.at(X, t));
}

TEST(FrameForce, AtPointsIsTheBodyForceOfTheFrame) {
  const std::vector<double> X{0.8, -0.5, 0.1, 1.3}, Y{0.2, 0.9, -1.0, 0.4};  // the last outside the ring
  const Response response(*ClosedForm::of(elastic_material(1e3, 0.3), vortex.baseline()));
  std::vector<double> x(4), y(4), b_x(4), b_y(4);
  BodyForceField field(vortex, 1000, X, Y);
  FrameForce force(vortex, spin, X, Y);
  for (const double t : {0.0, 0.3, 0.9}) {
    field.evaluate(response, t, x, y);
    b_x = x, b_y = y;
    force.apply(t, b_x, b_y);
    for (std::size_t p = 0; p < 4; ++p) {
      const Vector3 at(X[p], Y[p], 0);
      const Vector3 exact = Frame{0, spin}.rotation(t) * Vector3(x[p], y[p], 0) + added(at, t);
      EXPECT_NEAR(b_x[p], exact.x(), 1e-12 * (1 + exact.norm()));
      EXPECT_NEAR(b_y[p], exact.y(), 1e-12 * (1 + exact.norm()));
    }
  }
}

/// Means of the added terms over squares, within the ring, across its edges and outside, against many samples.
TEST(FrameForce, OverDomainsIsTheMeanOfThePoints) {
  constexpr double half = 0.025;
  const std::vector<double> X{0.9, 0.74, -1.02, 1.4}, Y{0.3, 0.1, 0.72, 0.1};
  std::vector<Rectangle> squares;
  for (std::size_t p = 0; p < X.size(); ++p) {
    squares.push_back({{X[p] - half, Y[p] - half}, {X[p] + half, Y[p] + half}});
  }
  FrameForce force(vortex, spin, X, Y, domains_of(squares, {vortex.inner, vortex.outer}, false));
  for (const double t : {0.2, 0.8}) {
    std::vector<double> b_x(X.size()), b_y(X.size());
    force.apply(t, b_x, b_y);
    for (std::size_t p = 0; p < X.size(); ++p) {
      constexpr int n = 200;
      Vector3 mean = Vector3::Zero();
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          mean += added({X[p] + half * ((2 * i + 1.0) / n - 1), Y[p] + half * ((2 * j + 1.0) / n - 1), 0}, t) / (n * n);
        }
      }
      EXPECT_NEAR(b_x[p], mean.x(), 1e-6 * mean.norm()) << p;
      EXPECT_NEAR(b_y[p], mean.y(), 1e-6 * mean.norm()) << p;
      const Vector3 centre = added({X[p], Y[p], 0}, t);
      if (p == 0) {
        EXPECT_GT(std::hypot(b_x[p] - centre.x(), b_y[p] - centre.y()), 1e-4 * centre.norm());
      }
    }
  }
}

}  // namespace
}  // namespace assay::test_frame_force
