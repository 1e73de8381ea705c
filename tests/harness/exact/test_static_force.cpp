// SPDX-License-Identifier: BSD-3-Clause
// The force without inertia: -DIV(P)/rho0 by differences of P, in all families, from any frame.
#include <gtest/gtest.h>

#include "harness/exact/exact_fields.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/numeric/central_difference.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_static_force {
namespace {

constexpr double rho = 1000, now = 0.4;
constexpr double step = 4e-3;            ///< [m]: the eighth power of it is rounding
constexpr double of_rounding = 1e-12;    ///< of the sizes of the parts of b
constexpr double of_closed_form = 1e-8;  ///< differences of a formula, of the largest
constexpr double of_sheet = 1e-6;        ///< of an interpolation, whose slope is less exact than itself

struct Row {
  std::string name;
  ExactSolutionPtr exact;
  bool in_space;
  double tolerance;
};

std::vector<Row> rows() {
  const auto material = elastic_material(1e5, 0.3);
  Vortex vortex;
  vortex.profile_power = 4;
  const TwistingRing ring{vortex, 0.06};
  AxisAligned box{{Amplitude::Type::sine, 0.1, 0.8}, false, true}, space = box;
  space.factors = Vector3(0.7, -1.2, 0.4), space.in_space = true;
  const Vortex3d ball{{.radius = 1.4, .axis = {1, 2, 3}}, {}, {Amplitude::Type::one_minus_cosine, 0.9, 1.3}};
  RotatingStretch stretch;
  stretch.stretch = 0.2, stretch.shear = 0.1, stretch.rotation = 0.7;
  const auto closed = [&](const Motion& motion) {
    return std::make_shared<const Response>(*ClosedForm::of(material, motion->baseline()));
  };
  const Sheet sheet(*material, Motion(ring)->baseline(), {.tolerance = 1e-11, .end = now});
  return {{"vortex", exact_polar(vortex, rho, closed(vortex)), false, of_closed_form},
          {"twisting_ring", exact_polar(ring, rho, std::make_shared<const Response>(sheet)), false, of_sheet},
          {"axis_aligned", exact_box(box, rho, material, {.end = now}), false, of_closed_form},
          {"axis_aligned in space", exact_box(space, rho, material, {.end = now}), true, of_closed_form},
          {"rotating_stretch", exact_uniform(stretch, rho, material, Motion(stretch)->baseline(), now, 1e-12), false,
           of_closed_form},
          {"vortex3d", exact_meridian(ball, rho, closed(ball)), true, of_closed_form}};
}

const std::vector<Vector3> places{{0.8, 0.45, 0.2}, {-0.62, 0.77, -0.4}, {0.3, -0.95, 0.1}};

Vector3 by_differences(const ExactSlice& slice, const Vector3& X) {
  Vector3 divergence = Vector3::Zero();
  for (int d = 0; d < 3; ++d) {
    divergence += central_difference(
        [&](int k) { return Vector3(slice.first_piola_kirchhoff(X + k * step * Vector3::Unit(d)).col(d)); }, step);
  }
  return -divergence / rho;
}

void check(const Row& row, const Frame& frame) {
  const auto seen = seen_from(frame, row.exact);
  const auto slice = seen->slice(now);
  double largest = 0, deviation = 0;
  for (const Vector3& of_body : places) {
    const Vector3 X = frame.rotation(0) * of_body;
    const ExactPoint point = slice->at(X);
    const Vector3 wanted = by_differences(*slice, X), &found = point.stress.static_force;
    largest = std::max(largest, wanted.norm());
    deviation = std::max(deviation, (found - wanted).norm());
    const double sizes = point.state.a.norm() + found.norm();
    EXPECT_LT((point.stress.body_force - point.state.a - found).norm(), of_rounding * sizes) << row.name;
    EXPECT_GT(point.state.a.norm(), 1e-2) << row.name;  // so that leaving it in is seen
  }
  EXPECT_LT(deviation, row.tolerance * largest + of_rounding) << row.name;
  EXPECT_EQ(largest > 1, row.name != "rotating_stretch") << row.name;
}

TEST(StaticForce, IsTheDivergenceAlone) {
  for (const Row& row : rows()) check(row, {});
}

TEST(StaticForce, AFrameOnlyTurnsIt) {
  for (const Row& row : rows())
    check(row, {0.7, 1.3, {0.4, -0.2, 0}, row.in_space ? Vector3(2, -1, 3) : Vector3(0, 0, 1)});
}

TEST(StaticForce, IsNoneOutsideTheRing) {
  for (const Row& row : rows()) {
    if (row.name != "vortex" && row.name != "vortex3d") continue;
    EXPECT_EQ(row.exact->at({1.6, 0.1, 0}, now).stress.static_force.norm(), 0);
  }
}

}  // namespace
}  // namespace assay::test_static_force
