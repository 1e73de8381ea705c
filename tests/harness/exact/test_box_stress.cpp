// SPDX-License-Identifier: BSD-3-Clause
// The series of the axis-aligned motion's stress against histories of single points, whose gradients are differences.
#include "harness/exact/box_stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "harness/exact/exact_fields.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/numeric/gauss.hpp"
#include "tests/harness/builtin_material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_box_stress {
namespace {

constexpr double box_density = 1000;
constexpr double of_series = 1e-7;     ///< ten times the tolerance that is asked for, of the largest
constexpr double of_gradients = 1e-6;  ///< of b: the differences of the other route, and the last modes' slopes
constexpr double box_rounding = 1e-12;

/// Factors of the plane that are not the usual ones.
const Vector3 other_factors(0.7, 1.2, 0);

AxisAligned sample_box(bool one_dimensional) {
  AxisAligned motion;
  motion.amplitude = {Amplitude::Type::sine, 0.1, 0.5};
  motion.one_dimensional = one_dimensional;
  return motion;
}

std::shared_ptr<const Material> elastic() { return elastic_material(1e4, 0.3); }
std::shared_ptr<const Material> zener() {
  return builtin_material(assay_builtin_zener, {{"E", 1e4}, {"nu", 0.3}, {"relaxation_time", 0.1}});
}

ExactStress of_point(const BoxStress& stress, const AxisAligned& motion, const Vector3& X, double t) {
  const BoxSeries::Local local = stress.series().at(X.x(), X.y());
  ExactStress found;
  for (int d = 0; d < 3; ++d) found.first_piola_kirchhoff(d, d) = local.piola[static_cast<std::size_t>(d)];
  found.body_force = motion.at(X, t).a - Vector3(local.along_X[0], local.along_Y[1], 0) / box_density;
  return found;
}

class BoxStressOf : public testing::TestWithParam<std::tuple<bool, bool>> {};

void check_against_single_points(const AxisAligned& motion, bool with_history) {
  const bool one_dimensional = motion.one_dimensional;
  const auto material = with_history ? zener() : elastic();
  BoxStress stress(material, motion, {.tolerance = 1e-8, .end = 0.5});
  EXPECT_EQ(stress.is_history(), with_history);
  EXPECT_EQ(stress.series().modes(1) == 1, one_dimensional);
  const std::array times{0.06, 0.21, 0.25, 0.48};
  const std::array points{Vector3(0.13, 0.71, 0), Vector3(0.5, 0.5, 0), Vector3(0.92, 0.05, 0), Vector3(0, 1, 0)};
  std::vector<std::vector<ExactStress>> expected;
  for (const Vector3& X : points) {
    std::vector<PlaceAndTime> places;
    for (const double t : times) places.push_back({X, t});
    expected.emplace_back();
    for (const ExactPoint& point : exact_box(motion, box_density, material, {})->at(places)) {
      expected.back().push_back(point.stress);
    }
  }
  for (std::size_t k = 0; k < times.size(); ++k) {
    stress.set_time(times[k]);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ExactStress found = of_point(stress, motion, points[i], times[k]), &right = expected[i][k];
      const double scale = right.first_piola_kirchhoff.norm() + 100, force = right.body_force.norm() + 1;
      EXPECT_LT((found.first_piola_kirchhoff - right.first_piola_kirchhoff).norm(), of_series * scale) << i << " " << k;
      EXPECT_LT((found.body_force - right.body_force).norm(), of_gradients * force) << i << " " << k;
    }
  }
  EXPECT_LT(stress.error(), 1e-8);
  EXPECT_GT(stress.material_calls(), 0);
}

TEST_P(BoxStressOf, AgreesWithHistoriesOfSinglePoints) {
  const auto [one_dimensional, with_history] = GetParam();
  check_against_single_points(sample_box(one_dimensional), with_history);
}

TEST_P(BoxStressOf, DoesSoWithOtherFactors) {
  const auto [one_dimensional, with_history] = GetParam();
  AxisAligned motion = sample_box(one_dimensional);
  motion.factors = other_factors;  // the bar has none
  check_against_single_points(motion, with_history);
}

INSTANTIATE_TEST_SUITE_P(Motions, BoxStressOf, testing::Combine(testing::Bool(), testing::Bool()), [](const auto& c) {
  return std::string(std::get<0>(c.param) ? "bar" : "box") + (std::get<1>(c.param) ? "_with_history" : "");
});

TEST(BoxStress, TakesAsManyModesAsTheToleranceNeedsAndSaysWhatIsLeft) {
  BoxStress rough(elastic(), sample_box(false), {.tolerance = 1e-3, .end = 0.5});
  BoxStress fine(elastic(), sample_box(false), {.tolerance = 1e-11, .end = 0.5});
  BoxStress bounded(elastic(), sample_box(false), {.tolerance = 1e-14, .end = 0.5, .most_modes = 8});
  EXPECT_LT(rough.series().modes(0), fine.series().modes(0));
  EXPECT_EQ(bounded.series().modes(0), 8);
  bounded.set_time(0.25), fine.set_time(0.25);
  EXPECT_GT(bounded.error(), 1e-14);
  const double left = std::abs(bounded.series().at(0.31, 0.77).piola[0] - fine.series().at(0.31, 0.77).piola[0]);
  EXPECT_LT(left, 10 * bounded.error() * 1e4);
}

TEST(BoxStress, HistoriesDoNotGoBack) {
  BoxStress stress(zener(), sample_box(true), {.tolerance = 1e-6, .end = 0.5});
  stress.set_time(0.2);
  EXPECT_THROW(stress.set_time(0.1), std::logic_error);
}

void check_means(const AxisAligned& motion) {
  BoxStress stress(elastic(), motion, {.tolerance = 1e-10, .end = 0.5});
  const double t = 0.17;
  stress.set_time(t);
  const std::vector<double> middle_X{0.225, 0.7, -0.05}, middle_Y{0.35, 0.7, 1.05};
  const auto exact = exact_box(motion, box_density, elastic(), {.tolerance = 1e-10, .end = 0.5});
  for (const Point& half : {Point{0.125, 0.05}, Point{0, 0}, Point{0.15, 0.15}}) {
    const auto force = exact->instant({middle_X, middle_Y, half}, {.force = true});
    std::vector<double> b_x(3), b_y(3);
    force->set_time(t);
    force->body_force(b_x, b_y);
    for (std::size_t p = 0; p < 3; ++p) {
      Vector3 mean = Vector3::Zero();
      for (const GaussPoint& x : gauss_points(12)) {
        for (const GaussPoint& y : gauss_points(12)) {
          const Rectangle r{{middle_X[p] - half[0], middle_Y[p] - half[1]},
                            {middle_X[p] + half[0], middle_Y[p] + half[1]}};
          const Vector3 X(r.lower[0] + 0.5 * (1 + x.at) * (r.upper[0] - r.lower[0]),
                          r.lower[1] + 0.5 * (1 + y.at) * (r.upper[1] - r.lower[1]), 0);
          mean += 0.25 * x.weight * y.weight * of_point(stress, motion, X, t).body_force;
        }
      }
      EXPECT_NEAR(b_x[p], mean.x(), box_rounding * (1 + mean.norm())) << p;
      EXPECT_NEAR(b_y[p], mean.y(), box_rounding * (1 + mean.norm())) << p;
    }
  }
}

TEST(BoxForce, IsThePointwiseForceAndItsMeanOverRectangles) {
  AxisAligned motion = sample_box(false);
  check_means(motion);
  motion.factors = other_factors;
  check_means(motion);
}

TEST(BoxForce, TheSeriesRefusesWhatLeavesThePlane) {
  AxisAligned motion = sample_box(false);
  motion.in_space = true;
  const auto exact = exact_box(motion, box_density, elastic(), {});
  EXPECT_FALSE(exact->source());  // points have updates or histories of their own
  const std::vector<double> X{0.2}, Y{0.4};
  EXPECT_THROW(exact->instant({X, Y}, {.stress = true}), std::logic_error);
}

TEST(BoxField, IsTheSeriesAtItsPoints) {
  BoxStress stress(elastic(), sample_box(false), {.tolerance = 1e-8, .end = 0.5});
  const std::vector<double> X{0.2, 0.2, 0.9}, Y{0.4, 0.8, 0.4};
  const auto exact = exact_box(sample_box(false), box_density, elastic(), {.tolerance = 1e-8, .end = 0.5});
  const auto field = exact->instant({X, Y}, {.stress = true});
  stress.set_time(0.3);
  field->set_time(0.3);
  for (std::size_t p = 0; p < X.size(); ++p) {
    const auto right = stress.series().at(X[p], Y[p]).piola;
    const PlaneState s = field->state(p);
    const Plane P = field->first_piola_kirchhoff(p);
    const std::array<double, 3> found{P[0], P[3], s.sigma[4] * s.F[0] * s.F[3]};
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], right[c], box_rounding * (1 + std::abs(right[c])));
  }
}

TEST(CosineRows, AreMeansOverTheirStretches) {
  using std::numbers::pi;
  const std::vector<Interval> stretches{{0.1, 0.4}, {0.6, 0.6}, {0.1, 0.4}, {-0.1, 0.1}};
  const CosineRows rows(9, stretches);
  EXPECT_EQ(rows.rows(), 3u);
  EXPECT_EQ(rows.row_of(0), rows.row_of(2));
  for (std::size_t p = 0; p < stretches.size(); ++p) {
    for (int k = 0; k < 9; ++k) {
      double mean = 0, slope = 0;
      for (const GaussPoint& point : gauss_points(16)) {
        const double X = stretches[p].lower + 0.5 * (1 + point.at) * stretches[p].width();
        mean += 0.5 * point.weight * std::cos(k * pi * X);
        slope -= 0.5 * point.weight * k * pi * std::sin(k * pi * X);
      }
      EXPECT_NEAR(rows.mean(rows.row_of(p))[static_cast<std::size_t>(k)], mean, box_rounding);
      EXPECT_NEAR(rows.slope(rows.row_of(p))[static_cast<std::size_t>(k)], slope, 30 * box_rounding);
    }
  }
}

}  // namespace
}  // namespace assay::test_box_stress
