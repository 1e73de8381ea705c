// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/exact_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/frame.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_inertia {
namespace {

constexpr double step = 1e-5;            ///< [m]
constexpr double of_differences = 1e-6;  ///< their round-off and third derivative, relative to the largest component
constexpr double rounding = 1e-13;

const std::vector<double> X{0.8, -0.3, 0.6, 1.24, 0.2, 0.0}, Y{0.2, 0.95, -0.7, 0.0, 0.1, 0.0};

/// By the frame's own formula, from the exact state.
Vector3 seen_acceleration(const Vortex& vortex, const Frame& frame, double x, double y, double t) {
  const Vector3 at(x, y, 0);
  return frame.seen(vortex.at(frame.body_point(at), t), t).a;
}

TEST(Inertia, IsTheFramesAccelerationAndItsGradient) {
  Vortex vortex;
  vortex.amplitude.peak = 0.7;
  for (const double spin : {0.0, 3.1}) {
    Frame frame;
    frame.spin = spin;
    const auto field = seen_from(frame, exact_polar(vortex, 1, nullptr))->instant({X, Y}, {.inertia = true});
    for (const double t : {0.0, 0.13, 0.5, 0.81}) {
      field->set_time(t);
      for (std::size_t p = 0; p < X.size(); ++p) {
        const auto found = field->inertia(p);
        const Vector3 a = seen_acceleration(vortex, frame, X[p], Y[p], t);
        const double scale = 1 + a.norm();
        for (int i = 0; i < 2; ++i) EXPECT_NEAR(found.a[static_cast<std::size_t>(i)], a[i], rounding * scale);
        const Vector3 along_x = (seen_acceleration(vortex, frame, X[p] + step, Y[p], t) -
                                 seen_acceleration(vortex, frame, X[p] - step, Y[p], t)) /
                                (2 * step);
        const Vector3 along_y = (seen_acceleration(vortex, frame, X[p], Y[p] + step, t) -
                                 seen_acceleration(vortex, frame, X[p], Y[p] - step, t)) /
                                (2 * step);
        const double size = 1 + along_x.norm() + along_y.norm();
        for (std::size_t i = 0; i < 2; ++i) {
          EXPECT_NEAR(found.gradient[2 * i], along_x[static_cast<int>(i)], of_differences * size) << t << " " << p;
          EXPECT_NEAR(found.gradient[2 * i + 1], along_y[static_cast<int>(i)], of_differences * size) << t << " " << p;
        }
      }
    }
  }
}

/// Motions of which a spin is not seen.
TEST(Inertia, IsTheMotionsAccelerationAndItsGradient) {
  TwistingRing ring;
  ring.expansion = 0.1;
  ring.twist.amplitude.peak = 0.7;
  AxisAligned box;
  box.amplitude = {Amplitude::Type::sine, 0.1, 0.8};
  RotatingStretch stretch;
  const std::vector<ExactSolutionPtr> solutions{exact_polar(ring, 1, nullptr),
                                                exact_box(box, 1, elastic_material(1e3, 0.3), {.tolerance = 1e-2}),
                                                exact_uniform(stretch, 1, [](double) { return Tensor::Zero(); })};
  for (const ExactSolutionPtr& solution : solutions) {
    const Motion& motion = solution->motion();
    const auto field = solution->instant({X, Y}, {.inertia = true});
    for (const double t : {0.13, 0.41}) {
      field->set_time(t);
      for (std::size_t p = 0; p < 4; ++p) {  // within the ring
        const auto a = [&](double x, double y) { return motion->at({x, y, 0}, t).a; };
        const Vector3 right = a(X[p], Y[p]), along_x = (a(X[p] + step, Y[p]) - a(X[p] - step, Y[p])) / (2 * step),
                      along_y = (a(X[p], Y[p] + step) - a(X[p], Y[p] - step)) / (2 * step);
        const auto found = field->inertia(p);
        const double size = 1 + right.norm() + along_x.norm() + along_y.norm();
        for (std::size_t i = 0; i < 2; ++i) {
          const auto d = static_cast<int>(i);
          EXPECT_NEAR(found.a[i], right[d], rounding * size);
          EXPECT_NEAR(found.gradient[2 * i], along_x[d], of_differences * size) << motion->type() << " " << p;
          EXPECT_NEAR(found.gradient[2 * i + 1], along_y[d], of_differences * size) << motion->type() << " " << p;
        }
      }
    }
  }
}

TEST(Inertia, IsNoneOutsideTheRingOfABodyAtRest) {
  const auto field = exact_polar(Vortex{}, 1, nullptr)->instant({X, Y}, {.inertia = true});
  field->set_time(0.3);
  for (const std::size_t p : {std::size_t{4}, std::size_t{5}}) {
    for (const double a : field->inertia(p).a) EXPECT_EQ(a, 0);
    for (const double slope : field->inertia(p).gradient) EXPECT_EQ(slope, 0);
  }
}

}  // namespace
}  // namespace assay::test_inertia
