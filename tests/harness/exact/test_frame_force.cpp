// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/exact_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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
  const auto response =
      std::make_shared<const Response>(*ClosedForm::of(elastic_material(1e3, 0.3), vortex.baseline()));
  std::vector<double> x(4), y(4), b_x(4), b_y(4);
  const auto own = exact_polar(vortex, 1000, response);
  const auto field = own->instant({X, Y}, {.force = true});
  const auto force = seen_from({0, spin}, own)->instant({X, Y}, {.force = true});
  for (const double t : {0.0, 0.3, 0.9}) {
    field->set_time(t), force->set_time(t);
    field->body_force(x, y);
    force->body_force(b_x, b_y);
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
  const auto own = exact_polar(vortex, 1, nullptr)->instant({X, Y, {half, half}}, {.motion = true});
  for (const double t : {0.2, 0.8}) {
    std::vector<double> b_x(X.size()), b_y(X.size());
    own->set_time(t);
    see_body_force({0, spin}, *own, t, b_x, b_y);
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
